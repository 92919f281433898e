<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="de">
  <context>
    <name>App::Property</name>
    <message>
      <source>A pin with a smaller area makes the design invalid. From 0 to 1000 mm2. Takes effect with Solve.</source>
      <translation>Ein Zapfen mit kleinerer Fläche macht den Entwurf ungültig. Von 0 bis 1000 mm2. Wirkt mit „Lösen“.</translation>
    </message>
    <message>
      <source>Add cylinders around the layout that carry the pull of the surplus membrane. Takes effect at once.</source>
      <translation>Zylinder um die Abwicklung setzen, die den Zug der überstehenden Membran aufnehmen. Wirkt sofort.</translation>
    </message>
    <message>
      <source>Choose how pieces are joined after printing: holes gives the tiles along their borders stitching holes. Takes effect with Solve.</source>
      <translation>Wählen, wie Stücke nach dem Druck verbunden werden: holes gibt den Kacheln an ihren Rändern Nählöcher. Wirkt mit „Lösen“.</translation>
    </message>
    <message>
      <source>Choose the energy of the membranes: tension-field (they wrinkle where squeezed) or plain neo-hookean. Takes effect with Verify.</source>
      <translation>Die Energie der Membranen wählen: tension-field (sie werfen Falten, wo sie gestaucht werden) oder einfach neo-hookean. Wirkt mit „Prüfen“.</translation>
    </message>
    <message>
      <source>Choose what a closed CAD part loses: its largest planar face (auto, largest), the faces in a plane (z=0), all below a plane (z&gt;0), all above it (z&lt;0), or nothing (none). Takes effect with Solve.</source>
      <translation>Wählen, was von einem geschlossenen CAD-Teil wegfällt: seine größte ebene Fläche (auto, largest), die Flächen in einer Ebene (z=0), alles unter einer Ebene (z&gt;0), alles darüber (z&lt;0) oder nichts (none). Wirkt mit „Lösen“.</translation>
    </message>
    <message>
      <source>Choose what carries the weight of the tiles: nothing (off leaves it out), the held tiles (held), or a plane below the piece (resting). Takes effect with Verify.</source>
      <translation>Wählen, was das Gewicht der Kacheln trägt: nichts (off lässt es weg), die gehaltenen Kacheln (held) oder eine Ebene unter dem Stück (resting). Wirkt mit „Prüfen“.</translation>
    </message>
    <message>
      <source>Choose what happens to a target that can't become tiles: off refuses it, on changes it. Takes effect with Solve.</source>
      <translation>Wählen, was mit einer Zielfläche geschieht, die keine Kacheln ergibt: off lehnt sie ab, on ändert sie. Wirkt mit „Lösen“.</translation>
    </message>
    <message>
      <source>Choose what holds the layout together after printing: a soluble slab, breakaway bridges or nothing (none). Takes effect at once.</source>
      <translation>Wählen, was die Abwicklung nach dem Druck zusammenhält: soluble (lösliche Platte), breakaway (Brücken zum Abbrechen) oder nichts (none). Wirkt sofort.</translation>
    </message>
    <message>
      <source>Choose what keeps contacts from sliding: bumps, dimples (bumps that snap into hollows) or nothing (none). Takes effect at once.</source>
      <translation>Wählen, was Kontakte am Rutschen hindert: bumps (Noppen), dimples (Noppen, die in Mulden einrasten) oder nichts (none). Wirkt sofort.</translation>
    </message>
    <message>
      <source>Choose which side faces up in the print. With front-down, breakaway bridges span between walls that stand already. Takes effect at once.</source>
      <translation>Wählen, welche Seite beim Druck oben liegt. Mit front-down spannen sich Brücken zum Abbrechen zwischen Wänden, die schon stehen. Wirkt sofort.</translation>
    </message>
    <message>
      <source>Choose which side of a CAD part with a wall becomes the target. Takes effect with Solve.</source>
      <translation>Wählen, welche Seite eines CAD-Teils mit Wand zur Zielfläche wird. Wirkt mit „Lösen“.</translation>
    </message>
    <message>
      <source>Clearance between a bump and its dimple. From 0 to 2 mm. Takes effect at once.</source>
      <translation>Spiel zwischen Noppe und Mulde. Von 0 bis 2 mm. Wirkt sofort.</translation>
    </message>
    <message>
      <source>Coefficient of Coulomb friction between tiles, also at bumps. From 0.01 to 10. Takes effect with Verify.</source>
      <translation>Koeffizient der Coulombschen Reibung zwischen Kacheln, auch an Noppen. Von 0.01 bis 10. Wirkt mit „Prüfen“.</translation>
    </message>
    <message>
      <source>Compare the print with the bed, gaps and features of this printer. Takes effect with the next export.</source>
      <translation>Den Druck mit Bett, Spalten und kleinsten Merkmalen dieses Druckers vergleichen. Wirkt mit dem nächsten Export.</translation>
    </message>
    <message>
      <source>Density of the tiles. It gives them their weight. From 0 to 30 g/cm3. Takes effect with Verify.</source>
      <translation>Dichte der Kacheln. Aus ihr folgt ihr Gewicht. Von 0 bis 30 g/cm3. Wirkt mit „Prüfen“.</translation>
    </message>
    <message>
      <source>Depth of the engraving. From 0.05 to 10 mm. Takes effect at once.</source>
      <translation>Tiefe der Gravur. Von 0.05 bis 10 mm. Wirkt sofort.</translation>
    </message>
    <message>
      <source>Depth to which a bridge enters each body. From 0 to 5 mm. Takes effect at once.</source>
      <translation>Tiefe, mit der eine Brücke in jeden Körper reicht. Von 0 bis 5 mm. Wirkt sofort.</translation>
    </message>
    <message>
      <source>Diameter of a friction bump at its wall. From 0.1 to 10 mm. Takes effect at once.</source>
      <translation>Durchmesser einer Reibnoppe an ihrer Wand. Von 0.1 bis 10 mm. Wirkt sofort.</translation>
    </message>
    <message>
      <source>Diameter of a stitching hole. Pins leave space for it, and p_floor of material stays around it. From 0.2 to 10 mm. Takes effect with Solve.</source>
      <translation>Durchmesser eines Nählochs. Zapfen lassen ihm Platz, und ringsum bleibt p_floor an Material stehen. Von 0.2 bis 10 mm. Wirkt mit „Lösen“.</translation>
    </message>
    <message>
      <source>Distance between the axes of neighbouring anchors. From 1 to 500 mm. Takes effect at once.</source>
      <translation>Abstand der Achsen benachbarter Anker. Von 1 bis 500 mm. Wirkt sofort.</translation>
    </message>
    <message>
      <source>Distance from the front pin tops down to the slab. It keeps the glue on the pins away from the slab. From 0 to 50 mm. Takes effect at once.</source>
      <translation>Abstand der Platte unter den vorderen Zapfenenden. Er hält den Kleber auf den Zapfen von der Platte fern. Von 0 bis 50 mm. Wirkt sofort.</translation>
    </message>
    <message>
      <source>Distance from the outline of the layout to the anchors. From 0.2 to 200 mm. Takes effect at once.</source>
      <translation>Abstand der Anker vom Umriss der Abwicklung. Von 0.2 bis 200 mm. Wirkt sofort.</translation>
    </message>
    <message>
      <source>Distance that pins keep from facing pins and from truncation planes at sharp folds. From 0 to 5 mm. Takes effect with Solve.</source>
      <translation>Abstand, den Zapfen an scharfen Falten von gegenüberliegenden Zapfen und von Kappungsebenen halten. Von 0 bis 5 mm. Wirkt mit „Lösen“.</translation>
    </message>
    <message>
      <source>Elongation at which the membranes break, as their maker states it. The report warns where they stretch further. From 1 to 5000 %. Takes effect with Verify.</source>
      <translation>Dehnung, bei der die Membranen laut Hersteller reißen. Der Bericht warnt, wo sie sich weiter dehnen. Von 1 bis 5000 %. Wirkt mit „Prüfen“.</translation>
    </message>
    <message>
      <source>Engrave name, piece, version and side on a tab beside one anchor of each piece. Takes effect at once.</source>
      <translation>Name, Stück, Version und Seite in eine Lasche an einem Anker jedes Stücks gravieren. Wirkt sofort.</translation>
    </message>
    <message>
      <source>Half the depth of the notches at which a bridge breaks. From 0 to 10 mm. Takes effect at once.</source>
      <translation>Halbe Tiefe der Kerben, an denen eine Brücke bricht. Von 0 bis 10 mm. Wirkt sofort.</translation>
    </message>
    <message>
      <source>Height of a friction bump above its wall. From 0.02 to 5 mm. Takes effect at once.</source>
      <translation>Höhe einer Reibnoppe über ihrer Wand. Von 0.02 bis 5 mm. Wirkt sofort.</translation>
    </message>
    <message>
      <source>Height of the pins. The membranes are glued to the tops of the pins. From 0.05 to 50 mm. Takes effect at once.</source>
      <translation>Höhe der Zapfen. Die Membranen werden auf die Enden der Zapfen geklebt. Von 0.05 bis 50 mm. Wirkt sofort.</translation>
    </message>
    <message>
      <source>Include the bumps in STL and 3MF files. Takes effect with the next export.</source>
      <translation>Die Noppen in STL- und 3MF-Dateien schreiben. Wirkt mit dem nächsten Export.</translation>
    </message>
    <message>
      <source>Keep creases of the target that are sharper than this as edges between tiles. 180 keeps none. From 1 to 180 deg. Takes effect with Solve.</source>
      <translation>Knicke der Zielfläche, die schärfer sind, als Kanten zwischen Kacheln behalten. Bei 180 bleibt keiner. Von 1 bis 180 deg. Wirkt mit „Lösen“.</translation>
    </message>
    <message>
      <source>L=auto keeps the tiles within this distance of the target. From 0.001 to 100 mm. Takes effect with Solve.</source>
      <translation>L=auto hält die Kacheln innerhalb dieses Abstands von der Zielfläche. Von 0.001 bis 100 mm. Wirkt mit „Lösen“.</translation>
    </message>
    <message>
      <source>Largest distance by which mending may move a point of the target. From 0 to 1000 mm. Takes effect with Solve.</source>
      <translation>Größter Abstand, um den das Ausbessern einen Punkt der Zielfläche verschieben darf. Von 0 bis 1000 mm. Wirkt mit „Lösen“.</translation>
    </message>
    <message>
      <source>Largest distance from the edge of a pin to the edge of its face. Pins farther away pull too weakly. From 0 to 50 mm. Takes effect with Solve.</source>
      <translation>Größter Abstand der Kante eines Zapfens von der Kante seiner Seite. Fernere Zapfen ziehen zu schwach. Von 0 bis 50 mm. Wirkt mit „Lösen“.</translation>
    </message>
    <message>
      <source>Largest distance of STL and 3MF facets from the curved surfaces (chord error). From 0.0001 to 1 mm. Takes effect with the next export.</source>
      <translation>Größter Abstand der STL- und 3MF-Facetten von den gekrümmten Flächen (Sehnenfehler). Von 0.0001 bis 1 mm. Wirkt mit dem nächsten Export.</translation>
    </message>
    <message>
      <source>Least area of a pin's top. It makes the glue hold. From 0 to 1000 mm2. Takes effect with Solve.</source>
      <translation>Kleinste Fläche eines Zapfenendes. Sie lässt den Kleber halten. Von 0 bis 1000 mm2. Wirkt mit „Lösen“.</translation>
    </message>
    <message>
      <source>Least distance between two tiles in the flat layout. Bumps on walls that are not recessed stand in this gap. From 0 to 20 mm. Takes effect with Solve.</source>
      <translation>Kleinster Abstand zweier Kacheln in der Abwicklung. Noppen auf Wänden, die nicht zurückstehen, ragen hinein. Von 0 bis 20 mm. Wirkt mit „Lösen“.</translation>
    </message>
    <message>
      <source>Least distance from the edge of a pin to the (recessed) edge of its face. From 0 to 20 mm. Takes effect with Solve.</source>
      <translation>Kleinster Abstand der Kante eines Zapfens von der (zurückgesetzten) Kante seiner Seite. Von 0 bis 20 mm. Wirkt mit „Lösen“.</translation>
    </message>
    <message>
      <source>Least normal force at each contact point, as a fraction of the mean normal force. From 0 to 1. Takes effect with Verify.</source>
      <translation>Kleinste Normalkraft an jedem Kontaktpunkt, als Bruchteil der mittleren Normalkraft. Von 0 bis 1. Wirkt mit „Prüfen“.</translation>
    </message>
    <message>
      <source>Let mending move the border of the target where tiles have too little space otherwise. Takes effect with Solve.</source>
      <translation>Dem Ausbessern erlauben, den Rand der Zielfläche zu verschieben, wo Kacheln sonst zu wenig Platz haben. Wirkt mit „Lösen“.</translation>
    </message>
    <message>
      <source>Let repair move vertices of the actuated surface slightly where poses and pins alone don't suffice. Takes effect with Solve.</source>
      <translation>Der Reparatur erlauben, Ecken der aktuierten Fläche etwas zu verschieben, wo Lagen und Zapfen allein nicht genügen. Wirkt mit „Lösen“.</translation>
    </message>
    <message>
      <source>List the faces of a CAD part that become the target, such as Face3,Face7-9. Skin and open choose them where the list is empty. Takes effect with Solve.</source>
      <translation>Die Flächen eines CAD-Teils angeben, die zur Zielfläche werden, etwa Face3,Face7-9. Ist die Liste leer, wählen skin und open sie aus. Wirkt mit „Lösen“.</translation>
    </message>
    <message>
      <source>List the tiles that carry the piece with gravity=held, such as T00012,T00345. An empty list stands for the lowest tiles. Takes effect with Verify.</source>
      <translation>Die Kacheln angeben, die das Stück mit gravity=held tragen, etwa T00012,T00345. Eine leere Liste steht für die tiefsten Kacheln. Wirkt mit „Prüfen“.</translation>
    </message>
    <message>
      <source>Mean edge length of the tiles. With --no-remesh the mesh decides. From 0.5 to 200 mm. Takes effect with Solve.</source>
      <translation>Mittlere Kantenlänge der Kacheln. Mit --no-remesh gilt die des Netzes. Von 0.5 bis 200 mm. Wirkt mit „Lösen“.</translation>
    </message>
    <message>
      <source>Move each wall that meets another one without bumps back by this. It makes up for the growth of printed walls (XY compensation). From 0 to 1 mm. Takes effect at once.</source>
      <translation>Jede Wand, die ohne Noppen an einer anderen liegt, um so viel zurücksetzen. Das gleicht aus, dass gedruckte Wände wachsen (XY-Kompensation). Von 0 bis 1 mm. Wirkt sofort.</translation>
    </message>
    <message>
      <source>Move walls with bumps back by half the bump height. This keeps the actuated shape from swelling. Takes effect at once.</source>
      <translation>Wände mit Noppen um die halbe Noppenhöhe zurücksetzen. So bläht sich die aktuierte Form nicht auf. Wirkt sofort.</translation>
    </message>
    <message>
      <source>Multiply the coordinates of a file without units by this factor (1000 for metres). From 1e-06 to 1e+06. Takes effect with Solve.</source>
      <translation>Die Koordinaten einer Datei ohne Einheiten mit diesem Faktor multiplizieren (1000 für Meter). Von 1e-06 bis 1e+06. Wirkt mit „Lösen“.</translation>
    </message>
    <message>
      <source>Number of bumps on an interface. Its two tiles share them. From 3 to 40. Takes effect at once.</source>
      <translation>Anzahl der Noppen einer Berührfläche. Ihre beiden Kacheln teilen sie sich. Von 3 bis 40. Wirkt sofort.</translation>
    </message>
    <message>
      <source>Number of pieces that the target is divided into (1 to 24). auto finds the smallest number that lies flat. Takes effect with Solve.</source>
      <translation>Anzahl der Stücke, in die die Zielfläche geteilt wird (1 bis 24). auto findet die kleinste Anzahl, die flach liegt. Wirkt mit „Lösen“.</translation>
    </message>
    <message>
      <source>Number of rows of bumps on an interface. From 2 to 10. Takes effect at once.</source>
      <translation>Anzahl der Reihen von Noppen auf einer Berührfläche. Von 2 bis 10. Wirkt sofort.</translation>
    </message>
    <message>
      <source>Radius of an anchor. From 0.5 to 100 mm. Takes effect at once.</source>
      <translation>Radius eines Ankers. Von 0.5 bis 100 mm. Wirkt sofort.</translation>
    </message>
    <message>
      <source>Scale the target until the longest side of its bounding box has this length. 0 leaves its size to scale. From 0 to 100000 mm. Takes effect with Solve.</source>
      <translation>Die Zielfläche skalieren, bis die längste Seite ihres Hüllquaders diese Länge hat. Bei 0 bestimmt scale die Größe. Von 0 bis 100000 mm. Wirkt mit „Lösen“.</translation>
    </message>
    <message>
      <source>Shear modulus of the back membrane (latex). From 0.001 to 1000 MPa. Takes effect with Verify.</source>
      <translation>Schubmodul der hinteren Membran (Latex). Von 0.001 bis 1000 MPa. Wirkt mit „Prüfen“.</translation>
    </message>
    <message>
      <source>Shear modulus of the front membrane (latex). From 0.001 to 1000 MPa. Takes effect with Verify.</source>
      <translation>Schubmodul der vorderen Membran (Latex). Von 0.001 bis 1000 MPa. Wirkt mit „Prüfen“.</translation>
    </message>
    <message>
      <source>Shear stress that the glue between membranes and print withstands. The report compares pins and anchors with it. From 0.001 to 100 MPa. Takes effect with Verify.</source>
      <translation>Scherspannung, die der Kleber zwischen Membranen und Druck aushält. Der Bericht vergleicht Zapfen und Anker damit. Von 0.001 bis 100 MPa. Wirkt mit „Prüfen“.</translation>
    </message>
    <message>
      <source>Size of the largest triangles of the coarser membrane mesh, as a fraction of L. Those of the finer mesh have half of it. From 0.05 to 2. Takes effect with Verify.</source>
      <translation>Größe der größten Dreiecke des gröberen Membrannetzes als Bruchteil von L. Die des feineren haben die Hälfte. Von 0.05 bis 2. Wirkt mit „Prüfen“.</translation>
    </message>
    <message>
      <source>Smallest value to which p_min may shrink at sharp folds. Use the smallest feature that the printer makes. From 0 to 20 mm. Takes effect with Solve.</source>
      <translation>Kleinster Wert, auf den p_min an scharfen Falten schrumpfen darf. Hier gehört das kleinste Merkmal hin, das der Drucker herstellt. Von 0 bis 20 mm. Wirkt mit „Lösen“.</translation>
    </message>
    <message>
      <source>Stretch ratio of the membranes when they are glued. 3 gives nine times the area. From 1.05 to 8. Takes effect with Solve.</source>
      <translation>Dehnung der Membranen beim Kleben. 3 ergibt die neunfache Fläche. Von 1.05 bis 8. Wirkt mit „Lösen“.</translation>
    </message>
    <message>
      <source>Swap front and back. Use this for a target whose normals point inwards. Takes effect with Solve.</source>
      <translation>Vorder- und Rückseite vertauschen, für Zielflächen, deren Normalen nach innen zeigen. Wirkt mit „Lösen“.</translation>
    </message>
    <message>
      <source>Thickness of a breakaway bridge. From 0.1 to 20 mm. Takes effect at once.</source>
      <translation>Dicke einer Brücke zum Abbrechen. Von 0.1 bis 20 mm. Wirkt sofort.</translation>
    </message>
    <message>
      <source>Thickness of a tile from its front face to its back face. From 0.2 to 100 mm. Takes effect at once.</source>
      <translation>Dicke einer Kachel von der Vorder- bis zur Rückseite. Von 0.2 bis 100 mm. Wirkt sofort.</translation>
    </message>
    <message>
      <source>Thickness of the back membrane before it is stretched. From 0.01 to 10 mm. Takes effect with Verify.</source>
      <translation>Dicke der hinteren Membran vor dem Dehnen. Von 0.01 bis 10 mm. Wirkt mit „Prüfen“.</translation>
    </message>
    <message>
      <source>Thickness of the front membrane before it is stretched. From 0.01 to 10 mm. Takes effect with Verify.</source>
      <translation>Dicke der vorderen Membran vor dem Dehnen. Von 0.01 bis 10 mm. Wirkt mit „Prüfen“.</translation>
    </message>
    <message>
      <source>Weight of the alignment energy, which puts facing edges opposite each other. From 0 to 1e+06. Takes effect with Solve.</source>
      <translation>Gewicht der Ausrichtungsenergie, die zugewandte Kanten einander gegenüberstellt. Von 0 bis 1e+06. Wirkt mit „Lösen“.</translation>
    </message>
    <message>
      <source>Weight of the packing energy, which draws facing edges together. From 0 to 1e+06. Takes effect with Solve.</source>
      <translation>Gewicht der Packungsenergie, die zugewandte Kanten zueinander zieht. Von 0 bis 1e+06. Wirkt mit „Lösen“.</translation>
    </message>
    <message>
      <source>Weight of the spring energy, which keeps the membranes well and evenly stretched. From 0 to 1e+06. Takes effect with Solve.</source>
      <translation>Gewicht der Federenergie, die die Membranen gut und gleichmäßig gedehnt hält. Von 0 bis 1e+06. Wirkt mit „Lösen“.</translation>
    </message>
    <message>
      <source>Width of a breakaway bridge. From 0.1 to 20 mm. Takes effect at once.</source>
      <translation>Breite einer Brücke zum Abbrechen. Von 0.1 bis 20 mm. Wirkt sofort.</translation>
    </message>
    <message>
      <source>Width of the slab around tiles and anchors. From 0.2 to 50 mm. Takes effect at once.</source>
      <translation>Breite der Platte um Kacheln und Anker herum. Von 0.2 bis 50 mm. Wirkt sofort.</translation>
    </message>
    <message>
      <source>Write STEP files as an assembly with one part per body, or as one part with one solid per body. Takes effect with the next export.</source>
      <translation>STEP-Dateien als Baugruppe mit einem Teil je Körper schreiben oder als ein Teil mit einem Volumenkörper je Körper. Wirkt mit dem nächsten Export.</translation>
    </message>
    <message>
      <source>x component of the direction of gravity. From -1 to 1. Takes effect with Verify.</source>
      <translation>x-Komponente der Richtung der Schwerkraft. Von -1 bis 1. Wirkt mit „Prüfen“.</translation>
    </message>
    <message>
      <source>y component of the direction of gravity. From -1 to 1. Takes effect with Verify.</source>
      <translation>y-Komponente der Richtung der Schwerkraft. Von -1 bis 1. Wirkt mit „Prüfen“.</translation>
    </message>
    <message>
      <source>z component of the direction of gravity. From -1 to 1. Takes effect with Verify.</source>
      <translation>z-Komponente der Richtung der Schwerkraft. Von -1 bis 1. Wirkt mit „Prüfen“.</translation>
    </message>
  </context>
  <context>
    <name>CheckPanel</name>
    <message>
      <source>Cancel</source>
      <translation>Abbrechen</translation>
    </message>
    <message>
      <source>Check</source>
      <translation>Machbarkeit</translation>
    </message>
    <message>
      <source>Choose Both</source>
      <translation>Beide wählen</translation>
    </message>
    <message>
      <source>Compare the worst value of each margin with the value it needs. Click a row to colour the tiles by it and to go to the worst tile</source>
      <translation>Den schlechtesten Wert jedes Spielraums mit dem nötigen vergleichen. Ein Klick auf eine Zeile färbt die Kacheln danach und geht zur schlechtesten</translation>
    </message>
    <message>
      <source>End now and leave the design unchanged</source>
      <translation>Jetzt aufhören und den Entwurf unverändert lassen</translation>
    </message>
    <message>
      <source>Find out which parts of the target can become tiles, and which sizes work</source>
      <translation>Herausfinden, welche Teile der Zielfläche Kacheln werden können und welche Größen gehen</translation>
    </message>
    <message>
      <source>Find the length and thickness of the largest tiles that can be made and stay within Fidelity of the surface</source>
      <translation>Länge und Dicke der größten Kacheln suchen, die sich machen lassen und innerhalb von Fidelity an der Fläche bleiben</translation>
    </message>
    <message>
      <source>Mend the Target</source>
      <translation>Zielfläche ausbessern</translation>
    </message>
    <message>
      <source>Read why tiles can't be made or are likely to fail. Click an entry to go there</source>
      <translation>Lesen, warum sich Kacheln nicht machen lassen oder wohl nicht halten. Ein Klick auf einen Eintrag führt hin</translation>
    </message>
    <message>
      <source>Set mend to on, which moves vertices of the target until these sizes work, and check again (one step of undo)</source>
      <translation>mend auf on setzen und die Machbarkeit neu ermitteln: das verschiebt Ecken der Zielfläche, bis diese Größen gehen (ein Schritt beim Rückgängigmachen)</translation>
    </message>
    <message>
      <source>Set the height of the pins and check again (one step of undo)</source>
      <translation>Die Höhe der Zapfen setzen und die Machbarkeit neu ermitteln (ein Schritt beim Rückgängigmachen)</translation>
    </message>
    <message>
      <source>Set the length of the tiles and check again (one step of undo)</source>
      <translation>Die Länge der Kacheln setzen und die Machbarkeit neu ermitteln (ein Schritt beim Rückgängigmachen)</translation>
    </message>
    <message>
      <source>Set the thickness of the tiles and check again (one step of undo)</source>
      <translation>Die Dicke der Kacheln setzen und die Machbarkeit neu ermitteln (ein Schritt beim Rückgängigmachen)</translation>
    </message>
    <message>
      <source>Sizes that work</source>
      <translation>Größen, die gehen</translation>
    </message>
  </context>
  <context>
    <name>CurveUps</name>
    <message>
      <source>Another task panel is open: close it first</source>
      <translation>Ein anderer Aufgabenbereich ist offen: ihn zuerst schließen</translation>
    </message>
    <message>
      <source>Close</source>
      <translation>Schließen</translation>
    </message>
    <message>
      <source>CurveUps is at work: stop or cancel that first</source>
      <translation>CurveUps arbeitet gerade: zuerst anhalten oder abbrechen</translation>
    </message>
    <message>
      <source>CurveUps: building solids ({seconds:.0f} s); an edit ends it</source>
      <translation>CurveUps: Volumenkörper werden gebaut ({seconds:.0f} s); eine Änderung beendet es</translation>
    </message>
    <message>
      <source>There are no solids yet: run Build Solids</source>
      <translation>Es gibt noch keine Volumenkörper: „Volumenkörper bauen“ macht sie</translation>
    </message>
    <message>
      <source>There are no tiles yet: run Solve</source>
      <translation>Es gibt noch keine Kacheln: „Lösen“ macht sie</translation>
    </message>
    <message>
      <source>There are several designs: select one</source>
      <translation>Es gibt mehrere Entwürfe: einen auswählen</translation>
    </message>
    <message>
      <source>There is no design: make one with New Design or Examples</source>
      <translation>Es gibt keinen Entwurf: „Neuer Entwurf“ oder „Beispiele“ legt einen an</translation>
    </message>
    <message>
      <source>There is no document</source>
      <translation>Es gibt kein Dokument</translation>
    </message>
    <message>
      <source>There is no layout yet: Solve makes it</source>
      <translation>Es gibt noch keine Abwicklung: „Lösen“ berechnet sie</translation>
    </message>
    <message>
      <source>There is no layout yet: run Solve</source>
      <translation>Es gibt noch keine Abwicklung: „Lösen“ berechnet sie</translation>
    </message>
    <message>
      <source>objects that were restored: {count}</source>
      <translation>wiederhergestellte Objekte: {count}</translation>
    </message>
    <message>
      <source>unexpected {kind} ({said}): please report it, with what CURVEUPS_DEBUG=1 shows</source>
      <translation>unerwarteter Fehler {kind} ({said}): bitte melden, mit dem, was CURVEUPS_DEBUG=1 zeigt</translation>
    </message>
    <message>
      <source>{task} was cancelled: the design is as it was</source>
      <translation>{task} wurde abgebrochen: der Entwurf ist wie zuvor</translation>
    </message>
  </context>
  <context>
    <name>CurveUpsCurves</name>
    <message>
      <source>Energy</source>
      <translation>Energie</translation>
    </message>
    <message>
      <source>Energy and violation appear here</source>
      <translation>Hier erscheinen Energie und Verletzung</translation>
    </message>
    <message>
      <source>Violation, mm</source>
      <translation>Verletzung, mm</translation>
    </message>
    <message>
      <source>Weak points</source>
      <translation>Schwache Punkte</translation>
    </message>
  </context>
  <context>
    <name>CurveUpsExport</name>
    <message>
      <source>Anchors</source>
      <translation>Anker</translation>
    </message>
    <message>
      <source>Export</source>
      <translation>Exportieren</translation>
    </message>
    <message>
      <source>Export {name}</source>
      <translation>{name} exportieren</translation>
    </message>
    <message>
      <source>Folder for the files</source>
      <translation>Ordner für die Dateien</translation>
    </message>
    <message>
      <source>Support</source>
      <translation>Stützkörper</translation>
    </message>
    <message>
      <source>Tiles</source>
      <translation>Kacheln</translation>
    </message>
    <message>
      <source>Tiles in shape</source>
      <translation>Kacheln in Form</translation>
    </message>
    <message>
      <source>Whole print</source>
      <translation>Ganzer Druck</translation>
    </message>
    <message>
      <source>choose one</source>
      <translation>einen auswählen</translation>
    </message>
    <message>
      <source>files in {folder}: {count}</source>
      <translation>Dateien in {folder}: {count}</translation>
    </message>
    <message>
      <source>open the folder</source>
      <translation>Ordner öffnen</translation>
    </message>
    <message>
      <source>open the report</source>
      <translation>Bericht öffnen</translation>
    </message>
    <message>
      <source>open {name} in the slicer</source>
      <translation>{name} im Slicer öffnen</translation>
    </message>
    <message>
      <source>there is no folder</source>
      <translation>es gibt keinen Ordner</translation>
    </message>
    <message>
      <source>{folder} holds the report of {other}. Replace it?</source>
      <translation>In {folder} liegt der Bericht von {other}. Ersetzen?</translation>
    </message>
  </context>
  <context>
    <name>CurveUpsPreferences</name>
    <message>
      <source>All other parameters: "Use for New Designs" in a design's panel.</source>
      <translation>Alle anderen Parameter: „Für neue Entwürfe“ im Aufgabenbereich eines Entwurfs.</translation>
    </message>
    <message>
      <source>Draw the layout while it is solved</source>
      <translation>Abwicklung während des Lösens zeichnen</translation>
    </message>
    <message>
      <source>Edge of a tile</source>
      <translation>Kante einer Kachel</translation>
    </message>
    <message>
      <source>General</source>
      <translation>Allgemein</translation>
    </message>
    <message>
      <source>Height of a pin</source>
      <translation>Höhe eines Zapfens</translation>
    </message>
    <message>
      <source>New designs begin with</source>
      <translation>Neue Entwürfe beginnen mit</translation>
    </message>
    <message>
      <source>Thickness of a tile</source>
      <translation>Dicke einer Kachel</translation>
    </message>
    <message>
      <source>While solving</source>
      <translation>Während des Lösens</translation>
    </message>
  </context>
  <context>
    <name>CurveUpsSolve</name>
    <message>
      <source>Anchors</source>
      <translation>Anker</translation>
    </message>
    <message>
      <source>Auto</source>
      <translation>Auto</translation>
    </message>
    <message>
      <source>Bodies</source>
      <translation>Körper</translation>
    </message>
    <message>
      <source>Bumps</source>
      <translation>Noppen</translation>
    </message>
    <message>
      <source>Check of the solids</source>
      <translation>Prüfung der Volumenkörper</translation>
    </message>
    <message>
      <source>Clearances</source>
      <translation>Abstände</translation>
    </message>
    <message>
      <source>Constraints</source>
      <translation>Bedingungen</translation>
    </message>
    <message>
      <source>Cuts</source>
      <translation>Schnitte</translation>
    </message>
    <message>
      <source>Design</source>
      <translation>Entwurf</translation>
    </message>
    <message>
      <source>Deviation</source>
      <translation>Abweichung</translation>
    </message>
    <message>
      <source>Edit the design</source>
      <translation>Entwurf bearbeiten</translation>
    </message>
    <message>
      <source>Feasibility</source>
      <translation>Machbarkeit</translation>
    </message>
    <message>
      <source>Feasibility smoothing</source>
      <translation>Glättung für die Machbarkeit</translation>
    </message>
    <message>
      <source>Files</source>
      <translation>Dateien</translation>
    </message>
    <message>
      <source>Layout</source>
      <translation>Abwicklung</translation>
    </message>
    <message>
      <source>Look for the largest value with which all tiles can be made. A length also keeps the tiles within Fidelity of the surface</source>
      <translation>Den größten Wert suchen, mit dem sich alle Kacheln machen lassen. Eine Länge hält die Kacheln auch innerhalb von Fidelity an der Fläche</translation>
    </message>
    <message>
      <source>Mending</source>
      <translation>Ausbessern</translation>
    </message>
    <message>
      <source>Other sizes</source>
      <translation>Andere Maße</translation>
    </message>
    <message>
      <source>Physics</source>
      <translation>Physik</translation>
    </message>
    <message>
      <source>Pieces</source>
      <translation>Stücke</translation>
    </message>
    <message>
      <source>Profile</source>
      <translation>Profil</translation>
    </message>
    <message>
      <source>Reading the surface</source>
      <translation>Fläche lesen</translation>
    </message>
    <message>
      <source>Repair</source>
      <translation>Reparieren</translation>
    </message>
    <message>
      <source>Revert all edits</source>
      <translation>Alles zurücknehmen</translation>
    </message>
    <message>
      <source>Set the defaults of all parameters that a profile sets</source>
      <translation>Die Vorgaben aller Parameter setzen, die ein Profil setzt</translation>
    </message>
    <message>
      <source>Solids</source>
      <translation>Volumenkörper</translation>
    </message>
    <message>
      <source>Standard</source>
      <translation>Standard</translation>
    </message>
    <message>
      <source>Suggestions</source>
      <translation>Vorschläge</translation>
    </message>
    <message>
      <source>Support</source>
      <translation>Stützkörper</translation>
    </message>
    <message>
      <source>Target</source>
      <translation>Zielfläche</translation>
    </message>
    <message>
      <source>Tiles</source>
      <translation>Kacheln</translation>
    </message>
    <message>
      <source>Verification</source>
      <translation>Prüfung</translation>
    </message>
    <message>
      <source>Verification of the layout</source>
      <translation>Prüfung der Abwicklung</translation>
    </message>
    <message>
      <source>Verification on a finer mesh</source>
      <translation>Prüfung auf feinerem Netz</translation>
    </message>
    <message>
      <source>empty</source>
      <translation>leer</translation>
    </message>
    <message>
      <source>invalid</source>
      <translation>ungültig</translation>
    </message>
    <message>
      <source>not judged</source>
      <translation>nicht beurteilt</translation>
    </message>
    <message>
      <source>not valid</source>
      <translation>nicht gültig</translation>
    </message>
    <message>
      <source>out of date</source>
      <translation>veraltet</translation>
    </message>
    <message>
      <source>running</source>
      <translation>läuft</translation>
    </message>
    <message>
      <source>stopping</source>
      <translation>wird angehalten</translation>
    </message>
    <message>
      <source>valid</source>
      <translation>gültig</translation>
    </message>
  </context>
  <context>
    <name>CurveUps_BuildSolids</name>
    <message>
      <source>Build Solids</source>
      <translation>Volumenkörper bauen</translation>
    </message>
    <message>
      <source>Build the solids of tiles, support and anchors with the present parameters</source>
      <translation>Die Volumenkörper von Kacheln, Stützkörper und Ankern mit den jetzigen Parametern bauen</translation>
    </message>
  </context>
  <context>
    <name>CurveUps_Check</name>
    <message>
      <source>Check</source>
      <translation>Machbarkeit</translation>
    </message>
    <message>
      <source>Check of {name}</source>
      <translation>Machbarkeit von {name}</translation>
    </message>
    <message>
      <source>Choose Sizes</source>
      <translation>Größen wählen</translation>
    </message>
    <message>
      <source>Feasible</source>
      <translation>Machbar</translation>
    </message>
    <message>
      <source>Find out which parts of the target can become tiles, and which sizes work, before you solve</source>
      <translation>Vor dem Lösen herausfinden, welche Teile der Zielfläche Kacheln werden können und welche Größen gehen</translation>
    </message>
    <message>
      <source>Margin</source>
      <translation>Spielraum</translation>
    </message>
    <message>
      <source>Needed</source>
      <translation>Nötig</translation>
    </message>
    <message>
      <source>Not feasible</source>
      <translation>Nicht machbar</translation>
    </message>
    <message>
      <source>Obstacles</source>
      <translation>Hindernisse</translation>
    </message>
    <message>
      <source>Out of date: check again</source>
      <translation>Veraltet: bitte erneut ermitteln</translation>
    </message>
    <message>
      <source>The largest that works: {values}</source>
      <translation>Der größte Wert, der geht: {values}</translation>
    </message>
    <message>
      <source>Tile</source>
      <translation>Kachel</translation>
    </message>
    <message>
      <source>Tiles below</source>
      <translation>Kacheln darunter</translation>
    </message>
    <message>
      <source>Use {name}</source>
      <translation>{name} übernehmen</translation>
    </message>
    <message>
      <source>Use {name} = {value}</source>
      <translation>{name} = {value} setzen</translation>
    </message>
    <message>
      <source>Worst</source>
      <translation>Schlechtester</translation>
    </message>
    <message>
      <source>and {count} more</source>
      <translation>und {count} weitere</translation>
    </message>
  </context>
  <context>
    <name>CurveUps_ColourMaps</name>
    <message>
      <source>Automatic</source>
      <translation>Automatisch</translation>
    </message>
    <message>
      <source>Blue-Orange</source>
      <translation>Blau-Orange</translation>
    </message>
    <message>
      <source>Grey</source>
      <translation>Grau</translation>
    </message>
  </context>
  <context>
    <name>CurveUps_Cuts</name>
    <message>
      <source>Accept suggested cuts</source>
      <translation>Vorgeschlagene Schnitte annehmen</translation>
    </message>
    <message>
      <source>Click Suggest first, then select a cut</source>
      <translation>Zuerst „Vorschlagen“ drücken, dann einen Schnitt wählen</translation>
    </message>
    <message>
      <source>Cut</source>
      <translation>Schnitt</translation>
    </message>
    <message>
      <source>Cuts</source>
      <translation>Schnitte</translation>
    </message>
    <message>
      <source>Cuts of {name}</source>
      <translation>Schnitte von {name}</translation>
    </message>
    <message>
      <source>Found no cut that is worth making</source>
      <translation>Kein Schnitt gefunden, der sich lohnt</translation>
    </message>
    <message>
      <source>Lay out</source>
      <translation>Abwickeln</translation>
    </message>
    <message>
      <source>Layout in {seconds:.1f} s. Solve repairs and verifies it.</source>
      <translation>Abwicklung in {seconds:.1f} s. „Lösen“ repariert und prüft sie.</translation>
    </message>
    <message>
      <source>Pick edges along which tiles are disconnected, or ask for suggestions</source>
      <translation>Kanten wählen, an denen Kacheln getrennt sind, oder Vorschläge holen</translation>
    </message>
    <message>
      <source>Remove cuts</source>
      <translation>Schnitte entfernen</translation>
    </message>
    <message>
      <source>Suggest</source>
      <translation>Vorschlagen</translation>
    </message>
    <message>
      <source>Take a cut back</source>
      <translation>Schnitt zurücknehmen</translation>
    </message>
    <message>
      <source>Target</source>
      <translation>Zielfläche</translation>
    </message>
    <message>
      <source>The rim is open already: click an edge inside</source>
      <translation>Der Rand ist schon offen: eine innere Kante anklicken</translation>
    </message>
    <message>
      <source>run Solve first</source>
      <translation>zuerst „Lösen“ ausführen</translation>
    </message>
    <message>
      <source>the layout is of another target</source>
      <translation>die Abwicklung gehört zu einer anderen Zielfläche</translation>
    </message>
  </context>
  <context>
    <name>CurveUps_Examples</name>
    <message>
      <source>Examples</source>
      <translation>Beispiele</translation>
    </message>
    <message>
      <source>Open a new document with a built-in target, and watch its design being solved</source>
      <translation>Ein neues Dokument mit einer eingebauten Zielfläche öffnen und zusehen, wie ihr Entwurf gelöst wird</translation>
    </message>
  </context>
  <context>
    <name>CurveUps_Export</name>
    <message>
      <source>Export Print Files</source>
      <translation>Druckdateien exportieren</translation>
    </message>
    <message>
      <source>Write 3MF, STEP and STL files of the bodies, and the report for the print shop</source>
      <translation>3MF-, STEP- und STL-Dateien der Körper und den Bericht für die Druckerei schreiben</translation>
    </message>
  </context>
  <context>
    <name>CurveUps_Fields</name>
    <message>
      <source>Conformal stretch</source>
      <translation>Konforme Dehnung</translation>
    </message>
    <message>
      <source>Deviation</source>
      <translation>Abweichung</translation>
    </message>
    <message>
      <source>Fold angle</source>
      <translation>Faltwinkel</translation>
    </message>
    <message>
      <source>Fold margin</source>
      <translation>Spielraum der Faltung</translation>
    </message>
    <message>
      <source>Friction ratio</source>
      <translation>Reibungsverhältnis</translation>
    </message>
    <message>
      <source>Gap</source>
      <translation>Spalt</translation>
    </message>
    <message>
      <source>Membrane room</source>
      <translation>Platz für Membranen</translation>
    </message>
    <message>
      <source>Membrane stretch</source>
      <translation>Membrandehnung</translation>
    </message>
    <message>
      <source>None</source>
      <translation>Keines</translation>
    </message>
    <message>
      <source>Normal force</source>
      <translation>Normalkraft</translation>
    </message>
    <message>
      <source>Obstacles</source>
      <translation>Hindernisse</translation>
    </message>
    <message>
      <source>Pin area</source>
      <translation>Zapfenfläche</translation>
    </message>
    <message>
      <source>Pin room</source>
      <translation>Platz für Zapfen</translation>
    </message>
    <message>
      <source>contacts below f_min</source>
      <translation>Kontakte unter f_min</translation>
    </message>
    <message>
      <source>contacts may slip</source>
      <translation>Kontakte können rutschen</translation>
    </message>
    <message>
      <source>gaps below DGapMin</source>
      <translation>Spalte unter DGapMin</translation>
    </message>
    <message>
      <source>tiles that can't be made or are likely to fail</source>
      <translation>Kacheln, die sich nicht machen lassen oder wohl nicht halten</translation>
    </message>
    <message>
      <source>tiles with less space for pins than APinMin, before Solve makes space</source>
      <translation>Kacheln mit weniger Platz für Zapfen als APinMin, bevor „Lösen“ welchen schafft</translation>
    </message>
    <message>
      <source>tiles with pins below APinMin</source>
      <translation>Kacheln mit Zapfen unter APinMin</translation>
    </message>
  </context>
  <context>
    <name>CurveUps_Guide</name>
    <message>
      <source>Back</source>
      <translation>Zurück</translation>
    </message>
    <message>
      <source>From a surface to print files; F1 opens it at the command under the mouse or at the panel that is open</source>
      <translation>Von der Fläche zu den Druckdateien; F1 öffnet es beim Befehl unter der Maus oder beim offenen Fenster</translation>
    </message>
    <message>
      <source>Guide</source>
      <translation>Anleitung</translation>
    </message>
    <message>
      <source>Guide to CurveUps</source>
      <translation>Anleitung zu CurveUps</translation>
    </message>
  </context>
  <context>
    <name>CurveUps_NewDesign</name>
    <message>
      <source>Make a design of the selected Part or Mesh object, of its selected faces, or of a file if nothing is selected</source>
      <translation>Einen Entwurf des gewählten Part- oder Mesh-Objekts, seiner gewählten Flächen oder, wenn nichts gewählt ist, einer Datei anlegen</translation>
    </message>
    <message>
      <source>New Design</source>
      <translation>Neuer Entwurf</translation>
    </message>
    <message>
      <source>Surfaces</source>
      <translation>Flächen</translation>
    </message>
  </context>
  <context>
    <name>CurveUps_Overlay</name>
    <message>
      <source>Choose the value that colours the tiles, fold them, and read their values</source>
      <translation>Den Wert wählen, der die Kacheln färbt, sie falten und ihre Werte ablesen</translation>
    </message>
    <message>
      <source>Membranes</source>
      <translation>Membranen</translation>
    </message>
    <message>
      <source>Overlay</source>
      <translation>Überlagerung</translation>
    </message>
    <message>
      <source>Overlay of {name}</source>
      <translation>Überlagerung von {name}</translation>
    </message>
    <message>
      <source>Tile</source>
      <translation>Kachel</translation>
    </message>
    <message>
      <source>Value</source>
      <translation>Wert</translation>
    </message>
    <message>
      <source>not the present state: {why}</source>
      <translation>nicht der jetzige Stand: {why}</translation>
    </message>
    <message>
      <source>of the layout, L = {length}, Tau = {tau}</source>
      <translation>des Layouts, L = {length}, Tau = {tau}</translation>
    </message>
    <message>
      <source>of the target, L = {length}</source>
      <translation>des Ziels, L = {length}</translation>
    </message>
    <message>
      <source>of the verified layout, L = {length}, Tau = {tau}</source>
      <translation>des geprüften Layouts, L = {length}, Tau = {tau}</translation>
    </message>
    <message>
      <source>out of date: {why}</source>
      <translation>veraltet: {why}</translation>
    </message>
    <message>
      <source>present state of the solver</source>
      <translation>jetziger Stand des Lösers</translation>
    </message>
  </context>
  <context>
    <name>CurveUps_Repair</name>
    <message>
      <source>Move tiles and pins of the layout until weak contacts hold</source>
      <translation>Kacheln und Zapfen der Abwicklung verschieben, bis schwache Kontakte halten</translation>
    </message>
    <message>
      <source>Repair</source>
      <translation>Reparieren</translation>
    </message>
  </context>
  <context>
    <name>CurveUps_Report</name>
    <message>
      <source>Report</source>
      <translation>Bericht</translation>
    </message>
    <message>
      <source>Write report.html, with verdict, pictures and figures, and open it</source>
      <translation>report.html mit Urteil, Bildern und Zahlen schreiben und öffnen</translation>
    </message>
  </context>
  <context>
    <name>CurveUps_RestoreObjects</name>
    <message>
      <source>Restore Objects</source>
      <translation>Objekte wiederherstellen</translation>
    </message>
    <message>
      <source>Restore designs that a FreeCAD without CurveUps saved</source>
      <translation>Entwürfe wiederherstellen, die ein FreeCAD ohne CurveUps gespeichert hat</translation>
    </message>
  </context>
  <context>
    <name>CurveUps_ShowActuated</name>
    <message>
      <source>Show Actuated</source>
      <translation>In Form zeigen</translation>
    </message>
    <message>
      <source>Show the tiles in the target shape</source>
      <translation>Die Kacheln in der Zielform zeigen</translation>
    </message>
  </context>
  <context>
    <name>CurveUps_ShowFlat</name>
    <message>
      <source>Show Flat</source>
      <translation>Flach zeigen</translation>
    </message>
    <message>
      <source>Show the tiles in the flat layout</source>
      <translation>Die Kacheln in der Abwicklung zeigen</translation>
    </message>
  </context>
  <context>
    <name>CurveUps_ShowSolids</name>
    <message>
      <source>Cancel</source>
      <translation>Abbrechen</translation>
    </message>
    <message>
      <source>Show Solids</source>
      <translation>Volumenkörper zeigen</translation>
    </message>
    <message>
      <source>Show tiles and anchors as printed solids. They are exact, but slow for thousands of tiles</source>
      <translation>Kacheln und Anker als gedruckte Volumenkörper zeigen. Sie sind genau, aber langsam bei Tausenden von Kacheln</translation>
    </message>
    <message>
      <source>Triangulating {count} solids</source>
      <translation>{count} Volumenkörper werden trianguliert</translation>
    </message>
    <message>
      <source>run Build Solids</source>
      <translation>„Volumenkörper bauen“ ausführen</translation>
    </message>
    <message>
      <source>there are no solids yet</source>
      <translation>es gibt noch keine Volumenkörper</translation>
    </message>
  </context>
  <context>
    <name>CurveUps_Solve</name>
    <message>
      <source>Lay the tiles out flat, verify that the membranes hold the shape, and repair weak contacts</source>
      <translation>Die Kacheln flach auslegen, prüfen, ob die Membranen die Form halten, und schwache Kontakte reparieren</translation>
    </message>
    <message>
      <source>Solve</source>
      <translation>Lösen</translation>
    </message>
  </context>
  <context>
    <name>CurveUps_SolverStatus</name>
    <message>
      <source>Folder</source>
      <translation>Ordner</translation>
    </message>
    <message>
      <source>Meanwhile</source>
      <translation>Einstweilen</translation>
    </message>
    <message>
      <source>Remedy</source>
      <translation>Abhilfe</translation>
    </message>
    <message>
      <source>Show the version and folder of the solver, or the reason why it can't be loaded and the remedy</source>
      <translation>Version und Ordner des Lösers zeigen, oder warum er sich nicht laden lässt und was hilft</translation>
    </message>
    <message>
      <source>Solver</source>
      <translation>Löser</translation>
    </message>
    <message>
      <source>Solver Status</source>
      <translation>Zustand des Lösers</translation>
    </message>
    <message>
      <source>State</source>
      <translation>Zustand</translation>
    </message>
    <message>
      <source>designs can be opened, shown and exported as they are stored</source>
      <translation>Entwürfe lassen sich öffnen, zeigen und exportieren, wie sie gespeichert sind</translation>
    </message>
    <message>
      <source>install the package for this FreeCAD's Python again</source>
      <translation>das Paket für das Python dieses FreeCAD neu installieren</translation>
    </message>
    <message>
      <source>none</source>
      <translation>keiner</translation>
    </message>
    <message>
      <source>ready; threads: {count}</source>
      <translation>bereit; Threads: {count}</translation>
    </message>
    <message>
      <source>run {command}, then start FreeCAD again</source>
      <translation>{command} ausführen, dann FreeCAD neu starten</translation>
    </message>
  </context>
  <context>
    <name>CurveUps_Target</name>
    <message>
      <source>Change Target</source>
      <translation>Zielfläche ändern</translation>
    </message>
    <message>
      <source>Give the design another surface: the selected Part or Mesh object, or a file</source>
      <translation>Dem Entwurf eine andere Fläche geben: das ausgewählte Part- oder Mesh-Objekt oder eine Datei</translation>
    </message>
  </context>
  <context>
    <name>CurveUps_Verify</name>
    <message>
      <source>Decide whether the present layout is valid with the present tiles and membranes</source>
      <translation>Entscheiden, ob die jetzige Abwicklung mit den jetzigen Kacheln und Membranen gültig ist</translation>
    </message>
    <message>
      <source>Verify</source>
      <translation>Prüfen</translation>
    </message>
  </context>
  <context>
    <name>CurveUps_WorstContacts</name>
    <message>
      <source>; better ones that are not listed: {left}</source>
      <translation>; bessere, die nicht aufgeführt sind: {left}</translation>
    </message>
    <message>
      <source>List contacts and tiles, the worst first. Click one to go there</source>
      <translation>Kontakte und Kacheln auflisten, die schlechtesten zuerst. Ein Klick führt hin</translation>
    </message>
    <message>
      <source>Problem</source>
      <translation>Problem</translation>
    </message>
    <message>
      <source>Tiles</source>
      <translation>Kacheln</translation>
    </message>
    <message>
      <source>Value</source>
      <translation>Wert</translation>
    </message>
    <message>
      <source>Worst Contacts</source>
      <translation>Schlechteste Kontakte</translation>
    </message>
    <message>
      <source>Worst of {name}</source>
      <translation>Schlechteste von {name}</translation>
    </message>
    <message>
      <source>with problems: {count}</source>
      <translation>mit Problemen: {count}</translation>
    </message>
  </context>
  <context>
    <name>CutsPanel</name>
    <message>
      <source>Accept</source>
      <translation>Annehmen</translation>
    </message>
    <message>
      <source>Begin another cut with the next click (Escape in the view)</source>
      <translation>Mit dem nächsten Klick einen anderen Schnitt beginnen (Escape in der Ansicht)</translation>
    </message>
    <message>
      <source>Click edges between tiles, flat or actuated. Each click continues the cut along the shortest path. Press Escape to begin another cut. Click a cut to remove it.</source>
      <translation>Kanten zwischen Kacheln anklicken, flach oder in Form. Jeder Klick verlängert den Schnitt auf dem kürzesten Weg. Escape beginnt einen anderen Schnitt. Ein Klick auf einen Schnitt entfernt ihn.</translation>
    </message>
    <message>
      <source>Cut</source>
      <translation>Schnitt</translation>
    </message>
    <message>
      <source>Cuts</source>
      <translation>Schnitte</translation>
    </message>
    <message>
      <source>Edges</source>
      <translation>Kanten</translation>
    </message>
    <message>
      <source>End the layout or the search for cuts, and keep the best so far</source>
      <translation>Die Abwicklung oder die Suche nach Schnitten beenden und das bisher Beste behalten</translation>
    </message>
    <message>
      <source>Lay out at once</source>
      <translation>Gleich abwickeln</translation>
    </message>
    <message>
      <source>Length</source>
      <translation>Länge</translation>
    </message>
    <message>
      <source>Look for cuts that let the target lie flat with less stretch, and predict what each one gains</source>
      <translation>Schnitte suchen, mit denen die Zielfläche mit weniger Dehnung flach liegt, und ihren Gewinn voraussagen</translation>
    </message>
    <message>
      <source>Make the layout anew after every cut. Solve repairs and verifies it</source>
      <translation>Nach jedem Schnitt neu abwickeln. „Lösen“ repariert und prüft die Abwicklung</translation>
    </message>
    <message>
      <source>Make the selected cut and the suggestions above it, which it builds on</source>
      <translation>Den gewählten Schnitt und die Vorschläge darüber machen, auf denen er aufbaut</translation>
    </message>
    <message>
      <source>New Cut</source>
      <translation>Neuer Schnitt</translation>
    </message>
    <message>
      <source>Number of cuts to look for</source>
      <translation>Anzahl der Schnitte, die gesucht werden</translation>
    </message>
    <message>
      <source>Remove</source>
      <translation>Entfernen</translation>
    </message>
    <message>
      <source>Remove the selected cuts, or all cuts if none is selected</source>
      <translation>Die gewählten Schnitte entfernen, oder alle, wenn keiner gewählt ist</translation>
    </message>
    <message>
      <source>Select connected cuts to mark them in the view</source>
      <translation>Zusammenhängende Schnitte wählen, um sie in der Ansicht zu markieren</translation>
    </message>
    <message>
      <source>Stop</source>
      <translation>Anhalten</translation>
    </message>
    <message>
      <source>Suggest</source>
      <translation>Vorschlagen</translation>
    </message>
    <message>
      <source>Suggested cuts</source>
      <translation>Vorgeschlagene Schnitte</translation>
    </message>
  </context>
  <context>
    <name>ExportPanel</name>
    <message>
      <source>Bodies</source>
      <translation>Körper</translation>
    </message>
    <message>
      <source>Cancel</source>
      <translation>Abbrechen</translation>
    </message>
    <message>
      <source>Deviation of bumps</source>
      <translation>Abweichung der Noppen</translation>
    </message>
    <message>
      <source>Export</source>
      <translation>Exportieren</translation>
    </message>
    <message>
      <source>Folder</source>
      <translation>Ordner</translation>
    </message>
    <message>
      <source>Format</source>
      <translation>Format</translation>
    </message>
    <message>
      <source>Largest distance of the triangles in STL and 3MF files from the bumps</source>
      <translation>Größter Abstand der Dreiecke in STL- und 3MF-Dateien von den Noppen</translation>
    </message>
    <message>
      <source>Names</source>
      <translation>Namen</translation>
    </message>
    <message>
      <source>With the report</source>
      <translation>Mit Bericht</translation>
    </message>
    <message>
      <source>Write the files although the design should not be printed. The files and the report say so</source>
      <translation>Die Dateien schreiben, obwohl der Entwurf nicht gedruckt werden sollte. Die Dateien und der Bericht sagen das</translation>
    </message>
    <message>
      <source>Write them anyway</source>
      <translation>Trotzdem schreiben</translation>
    </message>
    <message>
      <source>{name} stands for the design, {body} for what the file holds</source>
      <translation>{name} steht für den Entwurf, {body} für den Inhalt der Datei</translation>
    </message>
  </context>
  <context>
    <name>OverlayPanel</name>
    <message>
      <source>Actuated</source>
      <translation>In Form</translation>
    </message>
    <message>
      <source>Automatic range</source>
      <translation>Automatischer Bereich</translation>
    </message>
    <message>
      <source>Choose the colours. Each scale stays readable without red and green, and in grey</source>
      <translation>Die Farben wählen. Jede Skala bleibt ohne Rot und Grün und in Grau lesbar</translation>
    </message>
    <message>
      <source>Choose the value that colours the tiles. The value of a contact colours the nearest third of both its tiles</source>
      <translation>Wählen, welcher Wert die Kacheln färbt. Der Wert eines Kontakts färbt das nächste Drittel seiner beiden Kacheln</translation>
    </message>
    <message>
      <source>Click a tile to see its values</source>
      <translation>Eine Kachel anklicken, um ihre Werte zu sehen</translation>
    </message>
    <message>
      <source>Colour by</source>
      <translation>Färben nach</translation>
    </message>
    <message>
      <source>Colours</source>
      <translation>Farben</translation>
    </message>
    <message>
      <source>Flat</source>
      <translation>Flach</translation>
    </message>
    <message>
      <source>Fold the flat layout into the target shape. Every tile stays rigid</source>
      <translation>Die Abwicklung zur Zielform falten. Jede Kachel bleibt starr</translation>
    </message>
    <message>
      <source>From</source>
      <translation>Von</translation>
    </message>
    <message>
      <source>Give larger values the last colour. You can also drag the upper end of the legend</source>
      <translation>Größeren Werten die letzte Farbe geben. Auch das obere Ende der Legende lässt sich ziehen</translation>
    </message>
    <message>
      <source>Give smaller values the first colour. You can also drag the lower end of the legend</source>
      <translation>Kleineren Werten die erste Farbe geben. Auch das untere Ende der Legende lässt sich ziehen</translation>
    </message>
    <message>
      <source>Membranes</source>
      <translation>Membranen</translation>
    </message>
    <message>
      <source>Overlay</source>
      <translation>Überlagerung</translation>
    </message>
    <message>
      <source>Pins</source>
      <translation>Zapfen</translation>
    </message>
    <message>
      <source>Show all values except the lowest and highest hundredth. You can also double-click the legend</source>
      <translation>Alle Werte bis auf das unterste und oberste Hundertstel zeigen. Auch ein Doppelklick auf die Legende tut das</translation>
    </message>
    <message>
      <source>Show both membranes between the pins. CurveUps computes them the first time you ask for them</source>
      <translation>Beide Membranen zwischen den Zapfen zeigen. CurveUps berechnet sie, wenn Sie sie zum ersten Mal verlangen</translation>
    </message>
    <message>
      <source>Show the pins that the membranes are glued to</source>
      <translation>Die Zapfen zeigen, auf die die Membranen geklebt werden</translation>
    </message>
    <message>
      <source>Show the tiles flat and actuated at the same time</source>
      <translation>Die Kacheln zugleich flach und in Form zeigen</translation>
    </message>
    <message>
      <source>Side by side</source>
      <translation>Nebeneinander</translation>
    </message>
    <message>
      <source>To</source>
      <translation>Bis</translation>
    </message>
  </context>
  <context>
    <name>SolvePanel</name>
    <message>
      <source>Begin new designs with these parameters</source>
      <translation>Neue Entwürfe mit diesen Parametern beginnen</translation>
    </message>
    <message>
      <source>Cancel</source>
      <translation>Abbrechen</translation>
    </message>
    <message>
      <source>Decide whether the present layout is valid with the present membranes</source>
      <translation>Entscheiden, ob die jetzige Abwicklung mit den jetzigen Membranen gültig ist</translation>
    </message>
    <message>
      <source>Draw while solving</source>
      <translation>Beim Lösen zeichnen</translation>
    </message>
    <message>
      <source>End now and keep the best so far</source>
      <translation>Jetzt aufhören und das bisher Beste behalten</translation>
    </message>
    <message>
      <source>End now and leave the design unchanged</source>
      <translation>Jetzt aufhören und den Entwurf unverändert lassen</translation>
    </message>
    <message>
      <source>Lay the tiles out flat, verify that the membranes hold the shape, and repair weak contacts</source>
      <translation>Die Kacheln flach auslegen, prüfen, ob die Membranen die Form halten, und schwache Kontakte reparieren</translation>
    </message>
    <message>
      <source>Move tiles and pins until weak contacts hold</source>
      <translation>Kacheln und Zapfen verschieben, bis schwache Kontakte halten</translation>
    </message>
    <message>
      <source>Parameters</source>
      <translation>Parameter</translation>
    </message>
    <message>
      <source>Profile of the Printer</source>
      <translation>Profil des Druckers</translation>
    </message>
    <message>
      <source>Repair</source>
      <translation>Reparieren</translation>
    </message>
    <message>
      <source>Revert All Edits</source>
      <translation>Alles zurücknehmen</translation>
    </message>
    <message>
      <source>Set the parameters that suit a kind of printer (one step of undo)</source>
      <translation>Die Parameter setzen, die zu einer Art von Drucker passen (ein Schritt beim Rückgängigmachen)</translation>
    </message>
    <message>
      <source>Solve</source>
      <translation>Lösen</translation>
    </message>
    <message>
      <source>Stage</source>
      <translation>Schritt</translation>
    </message>
    <message>
      <source>Stop</source>
      <translation>Anhalten</translation>
    </message>
    <message>
      <source>Take back all changes of parameters since this panel opened (one step of undo)</source>
      <translation>Alle Änderungen an Parametern seit dem Öffnen dieses Fensters zurücknehmen (ein Schritt beim Rückgängigmachen)</translation>
    </message>
    <message>
      <source>Time</source>
      <translation>Zeit</translation>
    </message>
    <message>
      <source>Use for New Designs</source>
      <translation>Für neue Entwürfe</translation>
    </message>
    <message>
      <source>Verify</source>
      <translation>Prüfen</translation>
    </message>
  </context>
  <context>
    <name>Workbench</name>
    <message>
      <source>&amp;CurveUps</source>
      <translation>&amp;CurveUps</translation>
    </message>
    <message>
      <source>Design</source>
      <translation>Entwurf</translation>
    </message>
    <message>
      <source>Help</source>
      <translation>Hilfe</translation>
    </message>
    <message>
      <source>Show</source>
      <translation>Zeigen</translation>
    </message>
  </context>
  <context>
    <name>WorstContactsPanel</name>
    <message>
      <source>By</source>
      <translation>Nach</translation>
    </message>
    <message>
      <source>Choose the value that orders contacts and tiles. It colours the view too</source>
      <translation>Wählen, welcher Wert Kontakte und Kacheln ordnet. Er färbt auch die Ansicht</translation>
    </message>
    <message>
      <source>Worst Contacts</source>
      <translation>Schlechteste Kontakte</translation>
    </message>
  </context>
</TS>
