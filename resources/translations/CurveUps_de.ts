<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="de">
  <context>
    <name>App::Property</name>
    <message>
      <source>Bumps on an interface, both tiles together. From 3 to 40. Takes effect at once.</source>
      <translation>Noppen einer Berührfläche, beide Kacheln zusammen. Von 3 bis 40. Wirkt sofort.</translation>
    </message>
    <message>
      <source>Coulomb friction between tiles, at bumps as well. From 0.01 to 10. Takes effect with Verify.</source>
      <translation>Coulombsche Reibung zwischen Kacheln, auch an Noppen. Von 0.01 bis 10. Wirkt mit „Prüfen“.</translation>
    </message>
    <message>
      <source>Creases of the target sharper than this stay edges between tiles; 180: none does. From 1 to 180 deg. Takes effect with Solve.</source>
      <translation>Knicke der Zielfläche, die schärfer sind, bleiben Kanten zwischen Kacheln; 180: keiner. Von 1 bis 180 deg. Wirkt mit „Lösen“.</translation>
    </message>
    <message>
      <source>Cylinders around the layout that take the surplus membrane's pull. Takes effect at once.</source>
      <translation>Zylinder um die Abwicklung, die den Zug der überstehenden Membran aufnehmen. Wirkt sofort.</translation>
    </message>
    <message>
      <source>Density of the tiles, for gravity. From 0 to 30 g/cm3. Takes effect with Verify.</source>
      <translation>Dichte der Kacheln, für die Schwerkraft. Von 0 bis 30 g/cm3. Wirkt mit „Prüfen“.</translation>
    </message>
    <message>
      <source>Depth of the engraving. From 0.05 to 10 mm. Takes effect at once.</source>
      <translation>Tiefe der Gravur. Von 0.05 bis 10 mm. Wirkt sofort.</translation>
    </message>
    <message>
      <source>Diameter of a friction bump where it meets its wall. From 0.1 to 10 mm. Takes effect at once.</source>
      <translation>Durchmesser einer Reibnoppe an ihrer Wand. Von 0.1 bis 10 mm. Wirkt sofort.</translation>
    </message>
    <message>
      <source>Diameter of a stitching hole; p_floor of material stays around it, and pins make room for it. From 0.2 to 10 mm. Takes effect with Solve.</source>
      <translation>Durchmesser eines Nählochs; p_floor an Material bleibt darum stehen, und Zapfen machen ihm Platz. Von 0.2 bis 10 mm. Wirkt mit „Lösen“.</translation>
    </message>
    <message>
      <source>Direction in which gravity pulls: x. From -1 to 1. Takes effect with Verify.</source>
      <translation>Richtung, in die die Schwerkraft zieht: x. Von -1 bis 1. Wirkt mit „Prüfen“.</translation>
    </message>
    <message>
      <source>Direction in which gravity pulls: y. From -1 to 1. Takes effect with Verify.</source>
      <translation>Richtung, in die die Schwerkraft zieht: y. Von -1 bis 1. Wirkt mit „Prüfen“.</translation>
    </message>
    <message>
      <source>Direction in which gravity pulls: z. From -1 to 1. Takes effect with Verify.</source>
      <translation>Richtung, in die die Schwerkraft zieht: z. Von -1 bis 1. Wirkt mit „Prüfen“.</translation>
    </message>
    <message>
      <source>Distance between the axes of neighbouring anchors. From 1 to 500 mm. Takes effect at once.</source>
      <translation>Abstand der Achsen benachbarter Anker. Von 1 bis 500 mm. Wirkt sofort.</translation>
    </message>
    <message>
      <source>Distance of the anchors from the layout's outline. From 0.2 to 200 mm. Takes effect at once.</source>
      <translation>Abstand der Anker vom Umriss der Abwicklung. Von 0.2 bis 200 mm. Wirkt sofort.</translation>
    </message>
    <message>
      <source>Distance that pins keep from facing pins and truncation planes at sharp folds. From 0 to 5 mm. Takes effect with Solve.</source>
      <translation>Abstand, den Zapfen an scharfen Falten von gegenüberliegenden Zapfen und Kappungsebenen halten. Von 0 bis 5 mm. Wirkt mit „Lösen“.</translation>
    </message>
    <message>
      <source>Elongation at which membranes break, by their maker; a warning tells where they pass it. From 1 to 5000 %. Takes effect with Verify.</source>
      <translation>Dehnung, bei der Membranen laut Hersteller reißen; eine Warnung sagt, wo sie darüber liegen. Von 1 bis 5000 %. Wirkt mit „Prüfen“.</translation>
    </message>
    <message>
      <source>Energy of the membranes: tension-field (they wrinkle where squeezed) or plain neo-Hookean. Takes effect with Verify.</source>
      <translation>Energie der Membranen: Zugfeld (sie werfen Falten, wo sie gestaucht werden) oder einfach neo-hookesch. Wirkt mit „Prüfen“.</translation>
    </message>
    <message>
      <source>Engraves name, piece, version and side on a tab of one anchor of each piece. Takes effect at once.</source>
      <translation>Graviert Name, Stück, Version und Seite in eine Lasche an einem Anker jedes Stücks. Wirkt sofort.</translation>
    </message>
    <message>
      <source>Factor on the coordinates of a file without units (1000 for metres). From 1e-06 to 1e+06. Takes effect with Solve.</source>
      <translation>Faktor auf die Koordinaten einer Datei ohne Einheiten (1000 für Meter). Von 1e-06 bis 1e+06. Wirkt mit „Lösen“.</translation>
    </message>
    <message>
      <source>Farthest that mending may move a point of the target. From 0 to 1000 mm. Takes effect with Solve.</source>
      <translation>Wie weit das Ausbessern einen Punkt der Zielfläche höchstens verschieben darf. Von 0 bis 1000 mm. Wirkt mit „Lösen“.</translation>
    </message>
    <message>
      <source>Fit clearance between a bump and its dimple. From 0 to 2 mm. Takes effect at once.</source>
      <translation>Passungsspiel zwischen Noppe und Mulde. Von 0 bis 2 mm. Wirkt sofort.</translation>
    </message>
    <message>
      <source>Half the depth of the notches at which a bridge breaks. From 0 to 10 mm. Takes effect at once.</source>
      <translation>Halbe Tiefe der Kerben, an denen eine Brücke bricht. Von 0 bis 10 mm. Wirkt sofort.</translation>
    </message>
    <message>
      <source>Height of a friction bump over its wall. From 0.02 to 5 mm. Takes effect at once.</source>
      <translation>Höhe einer Reibnoppe über ihrer Wand. Von 0.02 bis 5 mm. Wirkt sofort.</translation>
    </message>
    <message>
      <source>Height of the pins on both faces, to whose tops membranes are glued. From 0.05 to 50 mm. Takes effect at once.</source>
      <translation>Höhe der Zapfen auf beiden Seiten, auf deren Enden die Membranen geklebt werden. Von 0.05 bis 50 mm. Wirkt sofort.</translation>
    </message>
    <message>
      <source>How deep a bridge enters each body. From 0 to 5 mm. Takes effect at once.</source>
      <translation>Wie tief eine Brücke in jeden Körper reicht. Von 0 bis 5 mm. Wirkt sofort.</translation>
    </message>
    <message>
      <source>How far the slab stays below the front pin tops, so that glue on these does not reach it. From 0 to 50 mm. Takes effect at once.</source>
      <translation>Wie weit die Platte unter den vorderen Zapfenenden bleibt, damit der Kleber darauf sie nicht erreicht. Von 0 bis 50 mm. Wirkt sofort.</translation>
    </message>
    <message>
      <source>How far walls that meet without bumps in between stand back, as prints grow (XY offset). From 0 to 1 mm. Takes effect at once.</source>
      <translation>Wie weit Wände zurückstehen, die ohne Noppen dazwischen aneinanderliegen, da Drucke wachsen (XY-Versatz). Von 0 bis 1 mm. Wirkt sofort.</translation>
    </message>
    <message>
      <source>How pieces are joined after printing: by stitching holes in the tiles along their borders, or none. Takes effect with Solve.</source>
      <translation>Wie Stücke nach dem Druck verbunden werden: durch Nählöcher in den Kacheln an ihren Rändern (holes), oder gar nicht (none). Wirkt mit „Lösen“.</translation>
    </message>
    <message>
      <source>Largest deviation of STL and 3MF from the curved surfaces. From 0.0001 to 1 mm. Takes effect with the next export.</source>
      <translation>Größte Abweichung von STL und 3MF von den gekrümmten Flächen. Von 0.0001 bis 1 mm. Wirkt mit dem nächsten Export.</translation>
    </message>
    <message>
      <source>Largest distance of the target from its tiles where L is auto. From 0.001 to 100 mm. Takes effect with Solve.</source>
      <translation>Größter Abstand der Zielfläche von ihren Kacheln, wenn L auto ist. Von 0.001 bis 100 mm. Wirkt mit „Lösen“.</translation>
    </message>
    <message>
      <source>Largest inset of a pin's edge: farther pins pull too weakly. From 0 to 50 mm. Takes effect with Solve.</source>
      <translation>Größter Abstand einer Zapfenkante: fernere Zapfen ziehen zu schwach. Von 0 bis 50 mm. Wirkt mit „Lösen“.</translation>
    </message>
    <message>
      <source>Largest triangles of the coarser membrane mesh as a part of L; the finer has half of it. From 0.05 to 2. Takes effect with Verify.</source>
      <translation>Größte Dreiecke des gröberen Membrannetzes als Teil von L; das feinere hat die Hälfte. Von 0.05 bis 2. Wirkt mit „Prüfen“.</translation>
    </message>
    <message>
      <source>Least area of a pin's top, so that the glue holds. From 0 to 1000 mm2. Takes effect with Solve.</source>
      <translation>Kleinste Fläche eines Zapfenendes, damit der Kleber hält. Von 0 bis 1000 mm2. Wirkt mit „Lösen“.</translation>
    </message>
    <message>
      <source>Least distance between any two tiles when flat; bumps on unrecessed walls stand into it. From 0 to 20 mm. Takes effect with Solve.</source>
      <translation>Kleinster Abstand zweier Kacheln in der Abwicklung; Noppen auf Wänden, die nicht zurückstehen, ragen hinein. Von 0 bis 20 mm. Wirkt mit „Lösen“.</translation>
    </message>
    <message>
      <source>Least inset of a pin's edge from its face's (recessed) edge. From 0 to 20 mm. Takes effect with Solve.</source>
      <translation>Kleinster Abstand einer Zapfenkante von der (zurückgesetzten) Kante ihrer Seite. Von 0 bis 20 mm. Wirkt mit „Lösen“.</translation>
    </message>
    <message>
      <source>Least normal force at contact points as a part of the mean normal force. From 0 to 1. Takes effect with Verify.</source>
      <translation>Kleinste Normalkraft an Kontaktpunkten als Teil der mittleren Normalkraft. Von 0 bis 1. Wirkt mit „Prüfen“.</translation>
    </message>
    <message>
      <source>Least normal forces as hard constraints, or weighed against fidelity by w_tight (penalty). Takes effect with Solve.</source>
      <translation>Kleinste Normalkräfte als harte Nebenbedingungen, oder mit w_tight gegen die Formtreue abgewogen (penalty). Wirkt mit „Lösen“.</translation>
    </message>
    <message>
      <source>Lets repair move the actuated vertices a little where poses and pins alone do not do. Takes effect with Solve.</source>
      <translation>Lässt die Reparatur die aktuierten Ecken etwas verschieben, wo Lagen und Zapfen allein nicht genügen. Wirkt mit „Lösen“.</translation>
    </message>
    <message>
      <source>Mean edge length of the tiles; with --no-remesh the mesh's own is used. From 0.5 to 200 mm. Takes effect with Solve.</source>
      <translation>Mittlere Kantenlänge der Kacheln; mit --no-remesh gilt die des Netzes. Von 0.5 bis 200 mm. Wirkt mit „Lösen“.</translation>
    </message>
    <message>
      <source>Mending may move the target's border, too, where tiles have no room otherwise. Takes effect with Solve.</source>
      <translation>Das Ausbessern darf auch den Rand der Zielfläche verschieben, wo Kacheln sonst keinen Platz haben. Wirkt mit „Lösen“.</translation>
    </message>
    <message>
      <source>Mends the target where it can't be tiles: not (off), only says what it would do (ask), or does (on). Takes effect with Solve.</source>
      <translation>Bessert die Zielfläche aus, wo sie keine Kacheln ergibt: nicht (off), sagt nur, was es täte (ask), oder tut es (on). Wirkt mit „Lösen“.</translation>
    </message>
    <message>
      <source>Pieces into which the target is divided, laid out side by side: 1 to 24, or auto (as few as lie flat). Takes effect with Solve.</source>
      <translation>Stücke, in die die Zielfläche geteilt wird, nebeneinander ausgelegt: 1 bis 24, oder auto (so wenige, wie flach liegen können). Wirkt mit „Lösen“.</translation>
    </message>
    <message>
      <source>Pins smaller than this make a design invalid. From 0 to 1000 mm2. Takes effect with Solve.</source>
      <translation>Kleinere Zapfen machen einen Entwurf ungültig. Von 0 bis 1000 mm2. Wirkt mit „Lösen“.</translation>
    </message>
    <message>
      <source>Printer whose bed, gaps and features the print is compared with. Takes effect with the next export.</source>
      <translation>Drucker, mit dessen Bett, Spalten und Strukturen der Druck verglichen wird. Wirkt mit dem nächsten Export.</translation>
    </message>
    <message>
      <source>Radius of an anchoring cylinder. From 0.5 to 100 mm. Takes effect at once.</source>
      <translation>Radius eines Ankerzylinders. Von 0.5 bis 100 mm. Wirkt sofort.</translation>
    </message>
    <message>
      <source>Recesses walls with bumps by half the height, so that bumps do not swell the actuated shape. Takes effect at once.</source>
      <translation>Setzt Wände mit Noppen um deren halbe Höhe zurück, damit Noppen die aktuierte Form nicht aufblähen. Wirkt sofort.</translation>
    </message>
    <message>
      <source>Rows in which the bumps of an interface stand. From 2 to 10. Takes effect at once.</source>
      <translation>Reihen, in denen die Noppen einer Berührfläche stehen. Von 2 bis 10. Wirkt sofort.</translation>
    </message>
    <message>
      <source>STEP files as an assembly with a part per body, or as one part with a solid per body. Takes effect with the next export.</source>
      <translation>STEP-Dateien als Baugruppe mit einem Teil je Körper oder als ein Teil mit einem Volumenkörper je Körper. Wirkt mit dem nächsten Export.</translation>
    </message>
    <message>
      <source>Scales the target so that its longest side (of its box along x, y, z) is this; 0: by scale. From 0 to 100000 mm. Takes effect with Solve.</source>
      <translation>Skaliert die Zielfläche so, dass ihre längste Seite (ihres Quaders entlang x, y, z) dies ist; 0: nach scale. Von 0 bis 100000 mm. Wirkt mit „Lösen“.</translation>
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
      <source>Shear stress that the glue between membranes and print holds: pins and anchors are compared. From 0.001 to 100 MPa. Takes effect with Verify.</source>
      <translation>Scherspannung, die der Kleber zwischen Membranen und Druck hält: Zapfen und Anker werden damit verglichen. Von 0.001 bis 100 MPa. Wirkt mit „Prüfen“.</translation>
    </message>
    <message>
      <source>Stretch of the membranes when glued; 3 is nine times the area. From 1.05 to 8. Takes effect with Solve.</source>
      <translation>Dehnung der Membranen beim Kleben; 3 ist die neunfache Fläche. Von 1.05 bis 8. Wirkt mit „Lösen“.</translation>
    </message>
    <message>
      <source>The faces of a CAD part that become the target, as Face3,Face7-9; none: chosen by skin and open. Takes effect with Solve.</source>
      <translation>Die Flächen eines CAD-Teils, die zur Zielfläche werden, als Face3,Face7-9; keine: gewählt nach skin und open. Wirkt mit „Lösen“.</translation>
    </message>
    <message>
      <source>Thickness of a breakaway bridge. From 0.1 to 20 mm. Takes effect at once.</source>
      <translation>Dicke einer Brücke zum Abbrechen. Von 0.1 bis 20 mm. Wirkt sofort.</translation>
    </message>
    <message>
      <source>Thickness of a tile between its front and its back face. From 0.2 to 100 mm. Takes effect at once.</source>
      <translation>Dicke einer Kachel zwischen Vorder- und Rückseite. Von 0.2 bis 100 mm. Wirkt sofort.</translation>
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
      <source>Tiles that carry the piece where gravity is held, as T00012,T00345; none: those at its lowest. Takes effect with Verify.</source>
      <translation>Kacheln, die das Stück tragen, wo Schwerkraft gehalten wird, als T00012,T00345; keine: die an seiner tiefsten Stelle. Wirkt mit „Prüfen“.</translation>
    </message>
    <message>
      <source>Turns front and back over, for targets whose normals point inwards. Takes effect with Solve.</source>
      <translation>Vertauscht Vorder- und Rückseite, für Zielflächen, deren Normalen nach innen zeigen. Wirkt mit „Lösen“.</translation>
    </message>
    <message>
      <source>Weight of missing normal force against deviation from the target where tightness is penalty. From 0 to 1e+09. Takes effect with Solve.</source>
      <translation>Gewicht fehlender Normalkraft gegen die Abweichung von der Zielfläche, wo tightness penalty ist. Von 0 bis 1e+09. Wirkt mit „Lösen“.</translation>
    </message>
    <message>
      <source>Weight of the alignment energy: facing edges opposite one another. From 0 to 1e+06. Takes effect with Solve.</source>
      <translation>Gewicht der Ausrichtungsenergie: zugewandte Kanten liegen einander gegenüber. Von 0 bis 1e+06. Wirkt mit „Lösen“.</translation>
    </message>
    <message>
      <source>Weight of the collision energy while constraints are soft. From 0 to 1e+09. Takes effect with Solve.</source>
      <translation>Gewicht der Kollisionsenergie, solange Nebenbedingungen weich sind. Von 0 bis 1e+09. Wirkt mit „Lösen“.</translation>
    </message>
    <message>
      <source>Weight of the packing energy: facing edges near one another. From 0 to 1e+06. Takes effect with Solve.</source>
      <translation>Gewicht der Packungsenergie: zugewandte Kanten liegen nahe beieinander. Von 0 bis 1e+06. Wirkt mit „Lösen“.</translation>
    </message>
    <message>
      <source>Weight of the pin area energy while constraints are soft. From 0 to 1e+09. Takes effect with Solve.</source>
      <translation>Gewicht der Zapfenflächenenergie, solange Nebenbedingungen weich sind. Von 0 bis 1e+09. Wirkt mit „Lösen“.</translation>
    </message>
    <message>
      <source>Weight of the spring energy: membranes evenly and well stretched. From 0 to 1e+06. Takes effect with Solve.</source>
      <translation>Gewicht der Federenergie: Membranen gleichmäßig und gut gedehnt. Von 0 bis 1e+06. Wirkt mit „Lösen“.</translation>
    </message>
    <message>
      <source>Weight of the tiles: left out, carried by held tiles, or by a plane on which the piece rests. Takes effect with Verify.</source>
      <translation>Gewicht der Kacheln: weggelassen, von gehaltenen Kacheln getragen oder von einer Ebene, auf der das Stück ruht. Wirkt mit „Prüfen“.</translation>
    </message>
    <message>
      <source>What holds contacts against sliding: bumps, dimples (bumps that snap into hollows) or none. Takes effect at once.</source>
      <translation>Was Kontakte gegen Rutschen hält: bumps (Noppen), dimples (Noppen, die in Mulden einrasten) oder none (nichts). Wirkt sofort.</translation>
    </message>
    <message>
      <source>What keeps the layout together after printing: soluble slab, breakaway bridges or none. Takes effect at once.</source>
      <translation>Was die Abwicklung nach dem Druck zusammenhält: soluble (lösliche Platte), breakaway (Brücken zum Abbrechen) oder none (nichts). Wirkt sofort.</translation>
    </message>
    <message>
      <source>What of a closed CAD part is left out: auto or largest (its largest planar face), the faces in a plane (z=0), all on one side of it (z&gt;0 keeps what is above), or none. Takes effect with Solve.</source>
      <translation>Was von einem geschlossenen CAD-Teil weggelassen wird: auto oder largest (seine größte ebene Fläche), die Flächen in einer Ebene (z=0), alles auf einer Seite davon (z&gt;0 behält, was darüber liegt), oder none. Wirkt mit „Lösen“.</translation>
    </message>
    <message>
      <source>Where folds leave no room p_min gives way, never below this: the printer's smallest feature. From 0 to 20 mm. Takes effect with Solve.</source>
      <translation>Wo Falten keinen Platz lassen, gibt p_min nach, doch nie unter diesen Wert: das kleinste Merkmal des Druckers. Von 0 bis 20 mm. Wirkt mit „Lösen“.</translation>
    </message>
    <message>
      <source>Whether STL and 3MF have the bumps. Takes effect with the next export.</source>
      <translation>Ob STL und 3MF die Noppen haben. Wirkt mit dem nächsten Export.</translation>
    </message>
    <message>
      <source>Which side of a CAD part that is drawn with a wall becomes the target. Takes effect with Solve.</source>
      <translation>Welche Seite eines CAD-Teils, das mit einer Wand gezeichnet ist, zur Zielfläche wird. Wirkt mit „Lösen“.</translation>
    </message>
    <message>
      <source>Which way up it is printed; front-down: breakaway bridges span between walls that stand. Takes effect at once.</source>
      <translation>Welche Seite beim Druck oben liegt; front-down (Vorderseite unten): Brücken zum Abbrechen spannen sich zwischen Wänden, die schon stehen. Wirkt sofort.</translation>
    </message>
    <message>
      <source>Width of a breakaway bridge. From 0.1 to 20 mm. Takes effect at once.</source>
      <translation>Breite einer Brücke zum Abbrechen. Von 0.1 bis 20 mm. Wirkt sofort.</translation>
    </message>
    <message>
      <source>Width of the slab around tiles and anchors. From 0.2 to 50 mm. Takes effect at once.</source>
      <translation>Breite der Platte um Kacheln und Anker herum. Von 0.2 bis 50 mm. Wirkt sofort.</translation>
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
      <source>End now and leave the design as it was</source>
      <translation>Jetzt aufhören und den Entwurf lassen, wie er war</translation>
    </message>
    <message>
      <source>Find out what of the target can be tiles, and which sizes would do</source>
      <translation>Herausfinden, was von der Zielfläche Kacheln werden kann und welche Größen gingen</translation>
    </message>
    <message>
      <source>Mend the Target</source>
      <translation>Zielfläche ausbessern</translation>
    </message>
    <message>
      <source>Moves vertices until the sizes that are set do: mend=on, one step of undo. It is checked at once</source>
      <translation>Verschiebt Ecken, bis die eingestellten Größen gehen: mend=on, ein Schritt beim Rückgängigmachen. Die Machbarkeit wird gleich neu ermittelt</translation>
    </message>
    <message>
      <source>Sets the height of the pins: one step of undo. It is checked at once</source>
      <translation>Setzt die Höhe der Stifte: ein Schritt beim Rückgängigmachen. Die Machbarkeit wird gleich neu ermittelt</translation>
    </message>
    <message>
      <source>Sets the tiles' length: one step of undo. It is checked at once</source>
      <translation>Setzt die Länge der Kacheln: ein Schritt beim Rückgängigmachen. Die Machbarkeit wird gleich neu ermittelt</translation>
    </message>
    <message>
      <source>Sets the tiles' thickness: one step of undo. It is checked at once</source>
      <translation>Setzt die Dicke der Kacheln: ein Schritt beim Rückgängigmachen. Die Machbarkeit wird gleich neu ermittelt</translation>
    </message>
    <message>
      <source>Sizes that would do</source>
      <translation>Größen, die gingen</translation>
    </message>
    <message>
      <source>The largest tiles that can be made and stay as near to the surface as Fidelity says, and their thickness</source>
      <translation>Die größten Kacheln, die sich machen lassen und so nah an der Fläche bleiben, wie Fidelity sagt, und ihre Dicke</translation>
    </message>
    <message>
      <source>What is compared, its worst value, and what is wanted. A click colours the tiles by it and goes to the worst one</source>
      <translation>Was verglichen wird, sein schlechtester Wert und was verlangt ist. Ein Klick färbt die Kacheln danach und geht zur schlechtesten</translation>
    </message>
    <message>
      <source>Why tiles can't be made, or are likely to fail; a click goes there</source>
      <translation>Warum sich Kacheln nicht machen lassen oder wohl nicht halten; ein Klick geht dorthin</translation>
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
      <source>about {size} in {seconds:.0f} s</source>
      <translation>etwa {size} in {seconds:.0f} s</translation>
    </message>
    <message>
      <source>another task panel is open</source>
      <translation>ein anderer Aufgabenbereich ist offen</translation>
    </message>
    <message>
      <source>choose one</source>
      <translation>einen auswählen</translation>
    </message>
    <message>
      <source>close it first</source>
      <translation>ihn zuerst schließen</translation>
    </message>
    <message>
      <source>files in {folder}: {count}</source>
      <translation>Dateien in {folder}: {count}</translation>
    </message>
    <message>
      <source>there is no folder</source>
      <translation>es gibt keinen Ordner</translation>
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
      <source>Files</source>
      <translation>Dateien</translation>
    </message>
    <message>
      <source>Layout</source>
      <translation>Abwicklung</translation>
    </message>
    <message>
      <source>Look for the largest value with which all tiles can be made; of lengths, as long as the surface stays within Fidelity</source>
      <translation>Sucht den größten Wert, mit dem sich alle Kacheln machen lassen; bei Längen, solange die Fläche innerhalb von Fidelity bleibt</translation>
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
      <translation>Alle Änderungen zurücknehmen</translation>
    </message>
    <message>
      <source>Room for pins</source>
      <translation>Platz für Zapfen</translation>
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
      <source>The defaults of all that a profile sets</source>
      <translation>Die Vorgaben für alles, was ein Profil setzt</translation>
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
      <source>another task panel is open</source>
      <translation>ein anderer Aufgabenbereich ist offen</translation>
    </message>
    <message>
      <source>close it first</source>
      <translation>ihn zuerst schließen</translation>
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
      <source>leave the edit mode of another object first</source>
      <translation>zuerst den Bearbeitungsmodus des anderen Objekts verlassen</translation>
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
      <source>the panel can't be opened</source>
      <translation>der Aufgabenbereich lässt sich nicht öffnen</translation>
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
      <source>Make tiles, support and anchors as solids, for the parameters as they are</source>
      <translation>Kacheln, Stützkörper und Anker als Volumenkörper bauen, mit den Parametern, wie sie sind</translation>
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
      <source>Find out what of the target can be tiles, and which sizes would do, before anything is solved</source>
      <translation>Herausfinden, was von der Zielfläche Kacheln werden kann und welche Größen gingen, bevor etwas gelöst wird</translation>
    </message>
    <message>
      <source>Margin</source>
      <translation>Spielraum</translation>
    </message>
    <message>
      <source>Not feasible</source>
      <translation>Nicht machbar</translation>
    </message>
    <message>
      <source>Out of date: check again</source>
      <translation>Veraltet: bitte erneut ermitteln</translation>
    </message>
    <message>
      <source>The largest that does: {values}</source>
      <translation>Der größte Wert, der geht: {values}</translation>
    </message>
    <message>
      <source>Tile</source>
      <translation>Kachel</translation>
    </message>
    <message>
      <source>Tiles short</source>
      <translation>Kacheln darunter</translation>
    </message>
    <message>
      <source>Use {name}</source>
      <translation>{name} übernehmen</translation>
    </message>
    <message>
      <source>Use {name} = {value}</source>
      <translation>{name} = {value} übernehmen</translation>
    </message>
    <message>
      <source>Wanted</source>
      <translation>Verlangt</translation>
    </message>
    <message>
      <source>What is in the way</source>
      <translation>Was im Weg ist</translation>
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
      <source>Lay out</source>
      <translation>Abwickeln</translation>
    </message>
    <message>
      <source>Let cuts be suggested first, and select one</source>
      <translation>Zuerst Schnitte vorschlagen lassen und einen wählen</translation>
    </message>
    <message>
      <source>No cut was found that is worth it</source>
      <translation>Kein Schnitt wurde gefunden, der sich lohnt</translation>
    </message>
    <message>
      <source>Pick edges along which tiles are disconnected, or let them be suggested</source>
      <translation>Kanten wählen, an denen Kacheln getrennt sind, oder sie vorschlagen lassen</translation>
    </message>
    <message>
      <source>Quick layout in {seconds:.1f} s; contacts that are likely to be weak (marked by triangles): {count}. Solve makes the real one.</source>
      <translation>Schnelle Abwicklung in {seconds:.1f} s; wohl schwache Kontakte (mit Dreiecken markiert): {count}. „Lösen“ macht die eigentliche.</translation>
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
      <source>The rim is open already: go on to an edge inside</source>
      <translation>Der Rand ist schon offen: zu einer inneren Kante weitergehen</translation>
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
      <source>A new document with a design of a built-in target, solved while you watch</source>
      <translation>Ein neues Dokument mit dem Entwurf einer eingebauten Zielfläche, vor Ihren Augen gelöst</translation>
    </message>
    <message>
      <source>Examples</source>
      <translation>Beispiele</translation>
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
      <source>tiles with less room for pins than APinMin, before Solve makes some</source>
      <translation>Kacheln mit weniger Platz für Zapfen als APinMin, bevor Lösen welchen schafft</translation>
    </message>
    <message>
      <source>tiles with pins below APinMin</source>
      <translation>Kacheln mit Zapfen unter APinMin</translation>
    </message>
  </context>
  <context>
    <name>CurveUps_NewDesign</name>
    <message>
      <source>A design of the selected Part or Mesh object, or of its selected faces; of a file where none is selected</source>
      <translation>Ein Entwurf des gewählten Part- oder Mesh-Objekts oder seiner gewählten Flächen; einer Datei, wenn keines gewählt ist</translation>
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
      <source>Choose what the tiles are coloured by, fold them, and read their values</source>
      <translation>Wählen, wonach die Kacheln gefärbt sind, sie falten und ihre Werte ablesen</translation>
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
      <source>as the solver has it</source>
      <translation>wie der Löser sie hat</translation>
    </message>
    <message>
      <source>not as it is now: {why}</source>
      <translation>nicht der jetzige Stand: {why}</translation>
    </message>
    <message>
      <source>out of date ({changed})</source>
      <translation>veraltet ({changed})</translation>
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
      <source>Makes designs whole again that were saved by a FreeCAD without CurveUps</source>
      <translation>Stellt Entwürfe wieder her, die ein FreeCAD ohne CurveUps gespeichert hat</translation>
    </message>
    <message>
      <source>Restore Objects</source>
      <translation>Objekte wiederherstellen</translation>
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
      <source>Show the tiles as they are printed</source>
      <translation>Die Kacheln zeigen, wie sie gedruckt werden</translation>
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
      <source>Show tiles and anchors as the solids that are printed: exact, but slow for thousands of tiles</source>
      <translation>Kacheln und Anker als die Volumenkörper zeigen, die gedruckt werden: genau, aber langsam bei Tausenden von Kacheln</translation>
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
      <source>Version and place of the solver; where it can't be loaded, why and what mends it</source>
      <translation>Version und Ort des Lösers; wenn er sich nicht laden lässt, warum, und was hilft</translation>
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
      <source>Judge the layout as it is, with tiles and membranes as they are set</source>
      <translation>Die Abwicklung beurteilen, wie sie ist, mit Kacheln und Membranen, wie sie eingestellt sind</translation>
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
      <source>List contacts and tiles, the worst first; a click goes there</source>
      <translation>Kontakte und Kacheln auflisten, die schlechtesten zuerst; ein Klick führt hin</translation>
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
      <source>A quick layout with soft constraints follows every cut; Solve makes the real one</source>
      <translation>Eine schnelle Abwicklung mit weichen Bedingungen folgt jedem Schnitt; „Lösen“ macht die eigentliche</translation>
    </message>
    <message>
      <source>Accept</source>
      <translation>Annehmen</translation>
    </message>
    <message>
      <source>Begin Anew</source>
      <translation>Neu beginnen</translation>
    </message>
    <message>
      <source>Click edges between tiles, flat or actuated: each click goes on from the last one along the shortest path. Escape begins anew; a click on a cut takes it back.</source>
      <translation>Kanten zwischen Kacheln anklicken, flach oder in Form: jeder Klick geht vom letzten auf dem kürzesten Weg weiter. Escape beginnt neu; ein Klick auf einen Schnitt nimmt ihn zurück.</translation>
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
      <source>Cuts that hang together; those selected here are marked in the view</source>
      <translation>Schnitte, die zusammenhängen; die hier gewählten sind in der Ansicht markiert</translation>
    </message>
    <message>
      <source>Edges</source>
      <translation>Kanten</translation>
    </message>
    <message>
      <source>Ends the quick layout, or the search for cuts, with what there is</source>
      <translation>Beendet die schnelle Abwicklung oder die Suche nach Schnitten mit dem, was da ist</translation>
    </message>
    <message>
      <source>How many cuts are looked for</source>
      <translation>Wie viele Schnitte gesucht werden</translation>
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
      <source>Looks for cuts that let the target lie flat with less stretch, with what they are predicted to gain</source>
      <translation>Sucht Schnitte, mit denen die Zielfläche mit weniger Dehnung flach liegt, mit ihrem voraussichtlichen Gewinn</translation>
    </message>
    <message>
      <source>Makes the selected suggestion and those before it, on which it rests</source>
      <translation>Macht den gewählten Vorschlag und die davor, auf denen er beruht</translation>
    </message>
    <message>
      <source>Remove</source>
      <translation>Entfernen</translation>
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
    <message>
      <source>Takes the selected cuts back, or all where none is selected</source>
      <translation>Nimmt die gewählten Schnitte zurück, oder alle, wenn keiner gewählt ist</translation>
    </message>
    <message>
      <source>The next click begins another cut (Escape in the view)</source>
      <translation>Der nächste Klick beginnt einen anderen Schnitt (Escape in der Ansicht)</translation>
    </message>
  </context>
  <context>
    <name>ExportPanel</name>
    <message>
      <source>About</source>
      <translation>Umfang</translation>
    </message>
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
      <source>How far the triangles of STL and 3MF files may be from the bumps</source>
      <translation>Wie weit die Dreiecke in STL- und 3MF-Dateien von den Noppen entfernt sein dürfen</translation>
    </message>
    <message>
      <source>Names</source>
      <translation>Namen</translation>
    </message>
    <message>
      <source>The files and the report then say that the design should not be printed</source>
      <translation>Die Dateien und der Bericht sagen dann, dass der Entwurf nicht gedruckt werden sollte</translation>
    </message>
    <message>
      <source>With report.html and report.json</source>
      <translation>Mit report.html und report.json</translation>
    </message>
    <message>
      <source>Write them all the same</source>
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
      <source>All of them keep their order without red and green, and as grey</source>
      <translation>Alle behalten ihre Ordnung ohne Rot und Grün und in Grau</translation>
    </message>
    <message>
      <source>All values but the hundredth at either end; a double click on the legend does the same</source>
      <translation>Alle Werte bis auf das Hundertstel an beiden Enden; ein Doppelklick auf die Legende tut dasselbe</translation>
    </message>
    <message>
      <source>Automatic range</source>
      <translation>Automatischer Bereich</translation>
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
      <source>Folds the flat layout to the target shape; every tile stays as it is</source>
      <translation>Faltet die Abwicklung zur Zielform; jede Kachel bleibt, wie sie ist</translation>
    </message>
    <message>
      <source>From</source>
      <translation>Von</translation>
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
      <source>Shows both membranes as they are between the pins; they are computed when they are first asked for</source>
      <translation>Zeigt beide Membranen, wie sie zwischen den Zapfen liegen; sie werden berechnet, wenn sie zum ersten Mal verlangt werden</translation>
    </message>
    <message>
      <source>Shows the pins that the membranes are glued to</source>
      <translation>Zeigt die Zapfen, auf die die Membranen geklebt werden</translation>
    </message>
    <message>
      <source>Shows the tiles flat and actuated at once</source>
      <translation>Zeigt die Kacheln zugleich flach und in Form</translation>
    </message>
    <message>
      <source>Side by side</source>
      <translation>Nebeneinander</translation>
    </message>
    <message>
      <source>To</source>
      <translation>Bis</translation>
    </message>
    <message>
      <source>Values above have the last colour; the upper end of the legend can be dragged too</source>
      <translation>Werte darüber haben die letzte Farbe; das obere Ende der Legende lässt sich auch ziehen</translation>
    </message>
    <message>
      <source>Values below have the first colour; the lower end of the legend can be dragged too</source>
      <translation>Werte darunter haben die erste Farbe; das untere Ende der Legende lässt sich auch ziehen</translation>
    </message>
    <message>
      <source>What the tiles are coloured by; values of a contact colour the third of both tiles beside it</source>
      <translation>Wonach die Kacheln gefärbt sind; der Wert eines Kontakts färbt das Drittel beider Kacheln daneben</translation>
    </message>
  </context>
  <context>
    <name>SolvePanel</name>
    <message>
      <source>Cancel</source>
      <translation>Abbrechen</translation>
    </message>
    <message>
      <source>Draw the layout while it is solved</source>
      <translation>Abwicklung während des Lösens zeichnen</translation>
    </message>
    <message>
      <source>End now and keep the best so far</source>
      <translation>Jetzt aufhören und das bisher Beste behalten</translation>
    </message>
    <message>
      <source>End now and leave the design as it was</source>
      <translation>Jetzt aufhören und den Entwurf lassen, wie er war</translation>
    </message>
    <message>
      <source>Judge the layout as it is with the membranes as they are set</source>
      <translation>Die Abwicklung beurteilen, wie sie ist, mit den Membranen, wie sie eingestellt sind</translation>
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
      <source>New designs begin with these parameters</source>
      <translation>Neue Entwürfe beginnen mit diesen Parametern</translation>
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
      <translation>Alle Änderungen zurücknehmen</translation>
    </message>
    <message>
      <source>Sets all parameters to what they were when this panel was opened: one step of undo</source>
      <translation>Setzt alle Parameter auf das, was sie beim Öffnen dieses Fensters waren: ein Schritt beim Rückgängigmachen</translation>
    </message>
    <message>
      <source>Sets the parameters that suit a kind of printer: one step of undo</source>
      <translation>Setzt die Parameter, die zu einer Art von Drucker passen: ein Schritt beim Rückgängigmachen</translation>
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
      <source>CurveUps</source>
      <translation>CurveUps</translation>
    </message>
  </context>
  <context>
    <name>WorstContactsPanel</name>
    <message>
      <source>By</source>
      <translation>Nach</translation>
    </message>
    <message>
      <source>What contacts and tiles are ordered by; the view is coloured by it too</source>
      <translation>Wonach Kontakte und Kacheln geordnet sind; auch die Ansicht ist danach gefärbt</translation>
    </message>
    <message>
      <source>Worst Contacts</source>
      <translation>Schlechteste Kontakte</translation>
    </message>
  </context>
</TS>
