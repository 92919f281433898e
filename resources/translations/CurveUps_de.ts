<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="de">
  <context>
    <name>ActuatePanel</name>
    <message>
      <source>Actuate</source>
      <translation>Aufrichten</translation>
    </message>
    <message>
      <source>Cancel</source>
      <translation>Abbrechen</translation>
    </message>
    <message>
      <source>Compute how a piece of the present design rises from flat</source>
      <translation>Berechnen, wie ein Stück des jetzigen Entwurfs aus der Ebene aufsteigt</translation>
    </message>
    <message>
      <source>Compute the Path</source>
      <translation>Weg berechnen</translation>
    </message>
    <message>
      <source>End now and keep the results so far</source>
      <translation>Jetzt beenden und die Ergebnisse bis dahin behalten</translation>
    </message>
    <message>
      <source>End now and leave the design unchanged</source>
      <translation>Jetzt aufhören und den Entwurf unverändert lassen</translation>
    </message>
    <message>
      <source>Flat</source>
      <translation>Flach</translation>
    </message>
    <message>
      <source>Move the tiles along the path</source>
      <translation>Die Kacheln auf ihrem Weg bewegen</translation>
    </message>
    <message>
      <source>Open Contacts</source>
      <translation>Offene Kontakte</translation>
    </message>
    <message>
      <source>Play</source>
      <translation>Abspielen</translation>
    </message>
    <message>
      <source>Play the path from flat to its end</source>
      <translation>Den Weg vom flachen Zustand bis zu seinem Ende abspielen</translation>
    </message>
    <message>
      <source>Pressed</source>
      <translation>Angedrückt</translation>
    </message>
    <message>
      <source>Select the tiles of the contacts that stay open at the end</source>
      <translation>Die Kacheln der Kontakte auswählen, die am Ende offen bleiben</translation>
    </message>
    <message>
      <source>Stop</source>
      <translation>Anhalten</translation>
    </message>
    <message>
      <source>The path is out of date: the design has changed since</source>
      <translation>Der Weg ist veraltet: der Entwurf hat sich seither geändert</translation>
    </message>
  </context>
  <context>
    <name>App::Property</name>
    <message>
      <source>Add cylinders around the layout that carry the pull of the surplus membrane. Takes effect at once.</source>
      <translation>Zylinder um die Abwicklung setzen, die den Zug der überstehenden Membran aufnehmen. Wirkt sofort.</translation>
    </message>
    <message>
      <source>Area that a pin's top gets where there is room. It makes the glue hold. From 0 to 1000 mm2. Takes effect with Solve.</source>
      <translation>Fläche, die ein Zapfenende bekommt, wo Platz ist. Sie lässt den Kleber halten. Von 0 bis 1000 mm2. Wirkt mit „Lösen“.</translation>
    </message>
    <message>
      <source>Choose how pieces are joined after printing: holes gives the tiles along their borders stitching holes. Takes effect with Solve.</source>
      <translation>Wählen, wie Stücke nach dem Druck verbunden werden: holes gibt den Kacheln an ihren Rändern Nählöcher. Wirkt mit „Lösen“.</translation>
    </message>
    <message>
      <source>Choose the energy of the membranes: tension-field (neo-Hookean; they wrinkle where squeezed) or plain neo-hookean. Takes effect with Verify.</source>
      <translation>Wählt die Energie der Membranen: tension-field (Neo-Hooke; sie werfen Falten, wo sie gestaucht werden) oder einfaches neo-hookean. Wirkt mit „Prüfen“.</translation>
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
      <source>Choose what is asked about margin_mismatch and margin_friction: nothing (off), a warning where the design does not bear them (report), or that it does (require). Takes effect with Verify.</source>
      <translation>Was zu margin_mismatch und margin_friction gefragt wird: nichts (off), eine Warnung, wo der Entwurf sie nicht verträgt (report), oder dass er es tut (require). Wirkt mit „Prüfen“.</translation>
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
      <source>Elongation at which the membranes break, as their maker states it. The report warns where they stretch further. From 1 to 5000 %. Takes effect with Verify.</source>
      <translation>Dehnung, bei der die Membranen laut Hersteller reißen. Der Bericht warnt, wo sie sich weiter dehnen. Von 1 bis 5000 %. Wirkt mit „Prüfen“.</translation>
    </message>
    <message>
      <source>Find how far front and back membrane may differ in pull and how far friction may change, each alone, until the shape no longer holds. Takes effect with Verify.</source>
      <translation>Sucht, wie verschieden Vorder- und Rückmembran ziehen dürfen und wie weit sich die Reibung ändern darf, jedes für sich, bis die Form nicht mehr hält. Wirkt mit „Prüfen“.</translation>
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
      <source>How much harder than the other either membrane may pull within the margin. From 0 to 90 %. Takes effect with Verify.</source>
      <translation>Um wie viel stärker als die andere jede Membran innerhalb der Reserve ziehen darf. Von 0 bis 90 %. Wirkt mit „Prüfen“.</translation>
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
      <source>Least area of a pin's top. A smaller pin makes the design invalid. From 0 to 1000 mm2. Takes effect with Solve.</source>
      <translation>Kleinste Fläche eines Zapfenendes. Ein kleinerer Zapfen macht den Entwurf ungültig. Von 0 bis 1000 mm2. Wirkt mit „Lösen“.</translation>
    </message>
    <message>
      <source>Least coefficient of friction within the margin. From 0.01 to 10. Takes effect with Verify.</source>
      <translation>Kleinster Reibungskoeffizient innerhalb der Reserve. Von 0.01 bis 10. Wirkt mit „Prüfen“.</translation>
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
      <source>Let OpenCASCADE check the solids of all bodies, slabs too, instead of 16 of each kind. Takes effect with the next export.</source>
      <translation>OpenCASCADE prüft die Solids aller Körper, auch Platten, statt 16 von jeder Art. Wirkt beim nächsten Export.</translation>
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
      <source>Move pins and tiles after repair until the design needs as little friction as it can, so that the piece comes to rest near the target by itself. Takes effect with Solve.</source>
      <translation>Stifte und Kacheln nach der Reparatur bewegen, bis der Entwurf so wenig Reibung braucht wie möglich und das Teil von selbst nahe am Ziel zur Ruhe kommt. Wirkt mit „Lösen“.</translation>
    </message>
    <message>
      <source>Multiply the coordinates of a file without units by this factor (1000 for metres). From 1e-06 to 1e+06. Takes effect with Solve.</source>
      <translation>Die Koordinaten einer Datei ohne Einheiten mit diesem Faktor multiplizieren (1000 für Meter). Von 1e-06 bis 1e+06. Wirkt mit „Lösen“.</translation>
    </message>
    <message>
      <source>Number of pieces that the target is divided into (1 to 24). auto finds the smallest number that lies flat. Takes effect with Solve.</source>
      <translation>Anzahl der Stücke, in die die Zielfläche geteilt wird (1 bis 24). auto findet die kleinste Anzahl, die flach liegt. Wirkt mit „Lösen“.</translation>
    </message>
    <message>
      <source>Radius of an anchor. From 0.5 to 100 mm. Takes effect at once.</source>
      <translation>Radius eines Ankers. Von 0.5 bis 100 mm. Wirkt sofort.</translation>
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
      <source>Shear stress that the glue between membranes and print withstands. A warning names pins that carry more. The verdict does not depend on it. From 0.001 to 100 MPa. Takes effect with Verify.</source>
      <translation>Schubspannung, die der Kleber zwischen Membranen und Druck aushält. Eine Warnung nennt Zapfen, die mehr tragen. Das Urteil hängt nicht davon ab. Von 0.001 bis 100 MPa. Wirkt mit „Prüfen“.</translation>
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
      <source>The shape holds where friction lets it drift by this at most, in the mean. 0 stands for 1 % of L. From 0 to 100 mm. Takes effect with Verify.</source>
      <translation>Die Form hält, wo die Reibung sie im Mittel höchstens um so viel abdriften lässt. 0 steht für 1 % von L. Von 0 bis 100 mm. Wirkt mit „Prüfen“.</translation>
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
      <source>Compare the worst value of each margin with the value it needs. ≈ marks an estimate: the layout may do a little better or worse. Click a row to colour the tiles by it and to go to the worst tile</source>
      <translation>Den schlechtesten Wert jedes Spielraums mit dem nötigen vergleichen. ≈ kennzeichnet eine Schätzung: die Abwicklung kann etwas besser oder schlechter ausfallen. Ein Klick auf eine Zeile färbt die Kacheln danach und geht zur schlechtesten</translation>
    </message>
    <message>
      <source>End now and leave the design unchanged</source>
      <translation>Jetzt aufhören und den Entwurf unverändert lassen</translation>
    </message>
    <message>
      <source>Find Sizes</source>
      <translation>Größen suchen</translation>
    </message>
    <message>
      <source>Find limits of length and thickness by estimates of the margins</source>
      <translation>Grenzen von Länge und Dicke mit Schätzungen der Spielräume suchen</translation>
    </message>
    <message>
      <source>Find out which parts of the target can become tiles</source>
      <translation>Herausfinden, welche Teile der Zielfläche Kacheln werden können</translation>
    </message>
    <message>
      <source>Margin</source>
      <translation>Spielraum</translation>
    </message>
    <message>
      <source>Needed</source>
      <translation>Soll</translation>
    </message>
    <message>
      <source>Obstacles</source>
      <translation>Hindernisse</translation>
    </message>
    <message>
      <source>Read why tiles can't be made or are likely to fail. Click an entry to go there</source>
      <translation>Lesen, warum sich Kacheln nicht machen lassen oder wohl nicht halten. Ein Klick auf einen Eintrag führt hin</translation>
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
    <message>
      <source>Solve for Both Sizes</source>
      <translation>Beide durch Lösen</translation>
    </message>
    <message>
      <source>Solve with a few lengths and thicknesses, the largest first, until a design is valid and its tiles stay within MaximumDeviation of the surface</source>
      <translation>Mit wenigen Längen und Dicken lösen, die größten zuerst, bis ein Entwurf gültig ist und seine Kacheln innerhalb von MaximumDeviation an der Fläche bleiben</translation>
    </message>
    <message>
      <source>Tile</source>
      <translation>Kachel</translation>
    </message>
    <message>
      <source>Worst</source>
      <translation>Ist</translation>
    </message>
  </context>
  <context>
    <name>CurveUps</name>
    <message>
      <source>Another task panel is open: close it first</source>
      <translation>Ein anderer Aufgabenbereich ist offen: ihn zuerst schließen</translation>
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
      <source>CurveUps: settling tiles ({seconds:.0f} s); an edit ends it</source>
      <translation>CurveUps: Kacheln setzen sich ({seconds:.0f} s); eine Änderung beendet das</translation>
    </message>
    <message>
      <source>Nothing is at work</source>
      <translation>Es läuft nichts</translation>
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
      <source>There is no layout yet: Solve makes it</source>
      <translation>Es gibt noch keine Abwicklung: „Lösen“ berechnet sie</translation>
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
      <source>Folder for the files</source>
      <translation>Ordner für die Dateien</translation>
    </message>
    <message>
      <source>Support</source>
      <translation>Stützkörper</translation>
    </message>
    <message>
      <source>This design has problems. Tick 'Write them anyway' to export its files</source>
      <translation>Dieser Entwurf hat Mängel. „Trotzdem schreiben“ ankreuzen, um seine Dateien zu exportieren</translation>
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
      <source>Names of print files</source>
      <translation>Namen der Druckdateien</translation>
    </message>
    <message>
      <source>New designs begin with</source>
      <translation>Neue Entwürfe beginnen mit</translation>
    </message>
    <message>
      <source>Panels</source>
      <translation>Aufgabenbereiche</translation>
    </message>
    <message>
      <source>Show parameters that are seldom needed, too</source>
      <translation>Auch Parameter zeigen, die man selten braucht</translation>
    </message>
    <message>
      <source>Thickness of a tile</source>
      <translation>Dicke einer Kachel</translation>
    </message>
    <message>
      <source>While solving</source>
      <translation>Während des Lösens</translation>
    </message>
    <message>
      <source>{name} stands for the design, {body} for what the file holds</source>
      <translation>{name} steht für den Entwurf, {body} für den Inhalt der Datei</translation>
    </message>
  </context>
  <context>
    <name>CurveUpsSolve</name>
    <message>
      <source> ({count} more)</source>
      <translation> ({count} weitere)</translation>
    </message>
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
      <source>Edge length</source>
      <translation>Kantenlänge</translation>
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
      <translation>Machbar glätten</translation>
    </message>
    <message>
      <source>Files</source>
      <translation>Dateien</translation>
    </message>
    <message>
      <source>First verification</source>
      <translation>Erste Prüfung</translation>
    </message>
    <message>
      <source>Friction</source>
      <translation>Reibung</translation>
    </message>
    <message>
      <source>From flat to shape</source>
      <translation>Aus der Ebene in die Form</translation>
    </message>
    <message>
      <source>Front over back</source>
      <translation>Vorn gegen hinten</translation>
    </message>
    <message>
      <source>Glue</source>
      <translation>Kleber</translation>
    </message>
    <message>
      <source>Largest pin inset</source>
      <translation>Größter Zapfenabstand</translation>
    </message>
    <message>
      <source>Layout</source>
      <translation>Abwicklung</translation>
    </message>
    <message>
      <source>Least force ratio</source>
      <translation>Kleinstes Kräfteverhältnis</translation>
    </message>
    <message>
      <source>Least gap</source>
      <translation>Kleinste Lücke</translation>
    </message>
    <message>
      <source>Least pin area</source>
      <translation>Kleinste Zapfenfläche</translation>
    </message>
    <message>
      <source>Least pin inset</source>
      <translation>Kleinster Zapfenabstand</translation>
    </message>
    <message>
      <source>Material of tiles</source>
      <translation>Material der Kacheln</translation>
    </message>
    <message>
      <source>Membrane</source>
      <translation>Membran</translation>
    </message>
    <message>
      <source>Mending</source>
      <translation>Ausbessern</translation>
    </message>
    <message>
      <source>Parameters</source>
      <translation>Parameter</translation>
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
      <source>Pin area</source>
      <translation>Zapfenfläche</translation>
    </message>
    <message>
      <source>Pin height</source>
      <translation>Zapfenhöhe</translation>
    </message>
    <message>
      <source>Pin inset</source>
      <translation>Zapfenabstand</translation>
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
      <source>Set the defaults of all parameters that a profile sets</source>
      <translation>Die Vorgaben aller Parameter setzen, die ein Profil setzt</translation>
    </message>
    <message>
      <source>Settled forces</source>
      <translation>Gesetzte Kräfte</translation>
    </message>
    <message>
      <source>Sheets of latex</source>
      <translation>Latexfolien</translation>
    </message>
    <message>
      <source>Sizes</source>
      <translation>Größen</translation>
    </message>
    <message>
      <source>Solids</source>
      <translation>Volumenkörper</translation>
    </message>
    <message>
      <source>Solve with a few values, the largest first, until a design is valid. A length also keeps the tiles within MaximumDeviation of the surface</source>
      <translation>Mit wenigen Werten lösen, die größten zuerst, bis ein Entwurf gültig ist. Eine Länge hält die Kacheln auch innerhalb von MaximumDeviation an der Fläche</translation>
    </message>
    <message>
      <source>Standard</source>
      <translation>Standard</translation>
    </message>
    <message>
      <source>Stretch</source>
      <translation>Dehnung</translation>
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
      <source>Target: {name}</source>
      <translation>Zielfläche: {name}</translation>
    </message>
    <message>
      <source>The fabrication kit is out of date</source>
      <translation>Der Bausatz ist veraltet</translation>
    </message>
    <message>
      <source>Thickness</source>
      <translation>Dicke</translation>
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
      <source>Warning: {what}</source>
      <translation>Warnung: {what}</translation>
    </message>
    <message>
      <source>does not hold</source>
      <translation>hält nicht</translation>
    </message>
    <message>
      <source>empty</source>
      <translation>leer</translation>
    </message>
    <message>
      <source>holds</source>
      <translation>hält</translation>
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
      <source>not settled</source>
      <translation>nicht gesetzt</translation>
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
    <name>CurveUps_Actuate</name>
    <message>
      <source>Actuate</source>
      <translation>Aufrichten</translation>
    </message>
    <message>
      <source>All contacts close</source>
      <translation>Alle Kontakte schließen sich</translation>
    </message>
    <message>
      <source>Compute the shape of the built piece: released from flat, shaken, and pressed over its former</source>
      <translation>Die Form des gebauten Stücks berechnen: flach losgelassen, geschüttelt und über seine Form gedrückt</translation>
    </message>
    <message>
      <source>Frame {number} of {count}, {load}: {energy} stored</source>
      <translation>Bild {number} von {count}, {load}: {energy} gespeichert</translation>
    </message>
    <message>
      <source>Pause</source>
      <translation>Pause</translation>
    </message>
    <message>
      <source>Play</source>
      <translation>Abspielen</translation>
    </message>
    <message>
      <source>The run was stopped before the path</source>
      <translation>Der Lauf wurde vor dem Weg angehalten</translation>
    </message>
    <message>
      <source>There is no path yet</source>
      <translation>Es gibt noch keinen Weg</translation>
    </message>
    <message>
      <source>pressed and let go</source>
      <translation>angedrückt und losgelassen</translation>
    </message>
    <message>
      <source>released</source>
      <translation>losgelassen</translation>
    </message>
    <message>
      <source>shaken</source>
      <translation>geschüttelt</translation>
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
      <source>Back / front</source>
      <translation>Hinten / vorn</translation>
    </message>
    <message>
      <source>Back membrane</source>
      <translation>Membran hinten</translation>
    </message>
    <message>
      <source>Back pin</source>
      <translation>Zapfen hinten</translation>
    </message>
    <message>
      <source>Check</source>
      <translation>Machbarkeit</translation>
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
      <source>Find Sizes</source>
      <translation>Größen suchen</translation>
    </message>
    <message>
      <source>Find out which parts of the target can become tiles, before you solve</source>
      <translation>Vor dem Lösen herausfinden, welche Teile der Zielfläche Kacheln werden können</translation>
    </message>
    <message>
      <source>Fold</source>
      <translation>Falz</translation>
    </message>
    <message>
      <source>Front membrane</source>
      <translation>Membran vorn</translation>
    </message>
    <message>
      <source>Front pin</source>
      <translation>Zapfen vorn</translation>
    </message>
    <message>
      <source>Least stretch</source>
      <translation>Dehnung min</translation>
    </message>
    <message>
      <source>Most stretch</source>
      <translation>Dehnung max</translation>
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
      <source>Overlaps</source>
      <translation>Durchdringung</translation>
    </message>
    <message>
      <source>Use {name}</source>
      <translation>{name} übernehmen</translation>
    </message>
    <message>
      <source>Use {sizes}</source>
      <translation>{sizes} setzen</translation>
    </message>
    <message>
      <source>and {count} more</source>
      <translation>und {count} weitere</translation>
    </message>
    <message>
      <source>likely: {why}</source>
      <translation>wahrscheinlich: {why}</translation>
    </message>
    <message>
      <source>{margin}: the worst tile is {tile}; tiles short of it: {count}</source>
      <translation>{margin}: die schlechteste Kachel ist {tile}; Kacheln, denen etwas fehlt: {count}</translation>
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
      <source>The next click already starts a new cut</source>
      <translation>Der nächste Klick beginnt schon einen neuen Schnitt</translation>
    </message>
    <message>
      <source>The rim is open already: click an edge inside</source>
      <translation>Der Rand ist schon offen: eine innere Kante anklicken</translation>
    </message>
    <message>
      <source>The target is being divided into tiles: click edges after that</source>
      <translation>Die Zielfläche wird in Kacheln geteilt: danach Kanten anklicken</translation>
    </message>
    <message>
      <source>There are no cuts</source>
      <translation>Es gibt keine Schnitte</translation>
    </message>
    <message>
      <source>layout with these cuts</source>
      <translation>Abwicklung mit diesen Schnitten</translation>
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
      <source>Dihedral angle</source>
      <translation>Diederwinkel</translation>
    </message>
    <message>
      <source>Dihedral margin</source>
      <translation>Spielraum des Diederwinkels</translation>
    </message>
    <message>
      <source>Distance of the built shape</source>
      <translation>Abstand der gebauten Form</translation>
    </message>
    <message>
      <source>Friction needed most</source>
      <translation>Höchster Reibungsbedarf</translation>
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
      <source>Membrane clearance</source>
      <translation>Abstand der Membranen</translation>
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
      <source>Open contacts</source>
      <translation>Offene Kontakte</translation>
    </message>
    <message>
      <source>Pin area</source>
      <translation>Zapfenfläche</translation>
    </message>
    <message>
      <source>Pin area margin</source>
      <translation>Spielraum der Zapfenfläche</translation>
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
      <source>contacts that stay open</source>
      <translation>Kontakte, die offen bleiben</translation>
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
      <source>tiles with less space for pins than APinFloor, before Solve makes space</source>
      <translation>Kacheln mit weniger Platz für Zapfen als APinFloor, bevor „Lösen“ welchen schafft</translation>
    </message>
    <message>
      <source>tiles with pins below APinFloor</source>
      <translation>Kacheln mit Zapfen unter APinFloor</translation>
    </message>
  </context>
  <context>
    <name>CurveUps_Findings</name>
    <message>
      <source> and {count} more</source>
      <translation> und {count} weitere</translation>
    </message>
    <message>
      <source>'{0}' can't be read</source>
      <translation>„{0}“ lässt sich nicht lesen</translation>
    </message>
    <message>
      <source>'{0}' is no face</source>
      <translation>„{0}“ ist keine Fläche</translation>
    </message>
    <message>
      <source>'{0}' is no file name</source>
      <translation>„{0}“ ist kein Dateiname</translation>
    </message>
    <message>
      <source>'{0}' is no name for a file</source>
      <translation>„{0}“ ist kein Name für eine Datei</translation>
    </message>
    <message>
      <source>'{0}' is no number of pieces</source>
      <translation>„{0}“ ist keine Anzahl von Stücken</translation>
    </message>
    <message>
      <source>'{0}' is no opening</source>
      <translation>„{0}“ ist keine Öffnung</translation>
    </message>
    <message>
      <source>'{0}' is no point of a scan</source>
      <translation>„{0}“ ist kein Punkt eines Scans</translation>
    </message>
    <message>
      <source>'{0}' is no setting</source>
      <translation>„{0}“ ist keine Einstellung</translation>
    </message>
    <message>
      <source>'{0}' is no tile</source>
      <translation>„{0}“ ist keine Kachel</translation>
    </message>
    <message>
      <source>* an estimate: the layout may do a little better or worse</source>
      <translation>* eine Schätzung: die Abwicklung kann etwas besser oder schlechter ausfallen</translation>
    </message>
    <message>
      <source>--no-remesh takes other tiles</source>
      <translation>--no-remesh nimmt andere Kacheln</translation>
    </message>
    <message>
      <source>; dimples stop what slides after {play:.3g mm} at most</source>
      <translation>; Mulden halten nach höchstens {play:.3g mm} auf, was gleitet</translation>
    </message>
    <message>
      <source>A_pin_floor ({0} mm2) is larger than A_pin_min ({1} mm2)</source>
      <translation>A_pin_floor ({0} mm2) ist größer als A_pin_min ({1} mm2)</translation>
    </message>
    <message>
      <source>CurveUps is at work already</source>
      <translation>CurveUps arbeitet schon</translation>
    </message>
    <message>
      <source>FreeCAD can't be loaded: {0}</source>
      <translation>FreeCAD lässt sich nicht laden: {0}</translation>
    </message>
    <message>
      <source>FreeCAD can't make triangles of the surface</source>
      <translation>FreeCAD kann die Fläche nicht in Dreiecke zerlegen</translation>
    </message>
    <message>
      <source>FreeCAD can't make triangles of {0}</source>
      <translation>FreeCAD kann {0} nicht in Dreiecke zerlegen</translation>
    </message>
    <message>
      <source>FreeCAD can't read the file</source>
      <translation>FreeCAD kann die Datei nicht lesen</translation>
    </message>
    <message>
      <source>FreeCAD has not made triangles within {0} s</source>
      <translation>FreeCAD hat binnen {0} s keine Dreiecke gemacht</translation>
    </message>
    <message>
      <source>FreeCAD's Python was not found</source>
      <translation>FreeCADs Python wurde nicht gefunden</translation>
    </message>
    <message>
      <source>H_body = {value:g mm}</source>
      <translation>H_body = {value:g mm}</translation>
    </message>
    <message>
      <source>H_body can be up to {H_body:g mm} (at L {L:.4g mm})</source>
      <translation>H_body kann bis zu {H_body:g mm} sein (bei L {L:.4g mm})</translation>
    </message>
    <message>
      <source>L = {value:g mm}</source>
      <translation>L = {value:g mm}</translation>
    </message>
    <message>
      <source>L and the edge of holes must be lengths</source>
      <translation>L und die Kante der Löcher müssen Längen sein</translation>
    </message>
    <message>
      <source>L can be {low:g mm} to {high:g mm} (at H_body {H_body:g mm})</source>
      <translation>L kann {low:g mm} bis {high:g mm} sein (bei H_body {H_body:g mm})</translation>
    </message>
    <message>
      <source>L can't be auto where the mesh is given</source>
      <translation>L kann nicht auto sein, wenn das Netz gegeben ist</translation>
    </message>
    <message>
      <source>L must be a positive length</source>
      <translation>L muss eine positive Länge sein</translation>
    </message>
    <message>
      <source>OpenCASCADE failed building {0} ({1})</source>
      <translation>OpenCASCADE konnte {0} nicht bauen ({1})</translation>
    </message>
    <message>
      <source>a coordinate of a solid is not finite</source>
      <translation>eine Koordinate eines Volumenkörpers ist nicht endlich</translation>
    </message>
    <message>
      <source>a cut near the tiles named gives gaps room</source>
      <translation>ein Schnitt nahe den genannten Kacheln gibt Spalten Platz</translation>
    </message>
    <message>
      <source>a cut of {length:.0f mm} {why:; }</source>
      <translation>ein Schnitt von {length:.0f mm}: {why:; }</translation>
    </message>
    <message>
      <source>a cut of {length:.0f mm} {why:; } (predicted: flat area {area_before:.2f} to {area_after:.2f} times the actuated, slack membrane at {slack_before} to {slack_after} places, energy per contact {energy_before:.2f} to {energy_after:.2f})</source>
      <translation>ein Schnitt von {length:.0f mm}: {why:; } (vorhergesagt: flache Fläche {area_before:.2f} auf {area_after:.2f} mal die in Form, schlaffe Membran an {slack_before} auf {slack_after} Stellen, Energie je Kontakt {energy_before:.2f} auf {energy_after:.2f})</translation>
    </message>
    <message>
      <source>a cut runs along no edge of the target</source>
      <translation>ein Schnitt verläuft entlang keiner Kante der Zielfläche</translation>
    </message>
    <message>
      <source>a face crosses itself</source>
      <translation>eine Fläche schneidet sich selbst</translation>
    </message>
    <message>
      <source>a face has {0} corners</source>
      <translation>eine Fläche hat {0} Ecken</translation>
    </message>
    <message>
      <source>a face names a vertex that is not there ({0} are)</source>
      <translation>eine Fläche nennt einen Punkt, den es nicht gibt (es gibt {0})</translation>
    </message>
    <message>
      <source>a facet can't be read, or the file ends early</source>
      <translation>eine Facette lässt sich nicht lesen, oder die Datei endet zu früh</translation>
    </message>
    <message>
      <source>a facet can't be read: {0}</source>
      <translation>eine Facette lässt sich nicht lesen: {0}</translation>
    </message>
    <message>
      <source>a file of an earlier run can't be removed: {0}</source>
      <translation>eine Datei eines früheren Laufs lässt sich nicht entfernen: {0}</translation>
    </message>
    <message>
      <source>a larger L, thinner tiles (H_body) or a smaller A_pin_min give pins room</source>
      <translation>ein größeres L, dünnere Kacheln (H_body) oder ein kleineres A_pin_min geben Zapfen Platz</translation>
    </message>
    <message>
      <source>a membrane triangle has no area in the actuated shape</source>
      <translation>ein Membrandreieck hat in Form keinen Flächeninhalt</translation>
    </message>
    <message>
      <source>a membrane triangle has no area in the layout</source>
      <translation>ein Membrandreieck hat in der Abwicklung keinen Flächeninhalt</translation>
    </message>
    <message>
      <source>a membrane would need about {0} triangles of {1} mm</source>
      <translation>eine Membran bräuchte etwa {0} Dreiecke von {1} mm</translation>
    </message>
    <message>
      <source>a part of a ring has less than three corners</source>
      <translation>ein Teil eines Rings hat weniger als drei Ecken</translation>
    </message>
    <message>
      <source>a part of the surface shrinks to a line at edges of this length</source>
      <translation>ein Teil der Fläche schrumpft bei Kanten dieser Länge zu einer Linie</translation>
    </message>
    <message>
      <source>a part or a hole of the surface is too small for edges of {0} mm</source>
      <translation>ein Teil oder ein Loch der Fläche ist zu klein für Kanten von {0} mm</translation>
    </message>
    <message>
      <source>a place beyond 10 m</source>
      <translation>ein Ort jenseits von 10 m</translation>
    </message>
    <message>
      <source>a polygon to be meshed is not simple and counter-clockwise</source>
      <translation>ein Polygon, das zu vernetzen ist, ist nicht einfach und gegen den Uhrzeigersinn</translation>
    </message>
    <message>
      <source>a polyline has to have two or more points of three numbers</source>
      <translation>ein Linienzug braucht zwei oder mehr Punkte aus drei Zahlen</translation>
    </message>
    <message>
      <source>a region that is none, or has a corner beyond 10 m</source>
      <translation>ein Bereich, der keiner ist oder eine Ecke jenseits von 10 m hat</translation>
    </message>
    <message>
      <source>a repair step holds numbers that are not finite</source>
      <translation>ein Schritt der Reparatur enthält Zahlen, die nicht endlich sind</translation>
    </message>
    <message>
      <source>a ring has a point that is not finite or beyond 10 m</source>
      <translation>ein Ring hat einen Punkt, der nicht endlich ist oder jenseits von 10 m liegt</translation>
    </message>
    <message>
      <source>a ring has no part</source>
      <translation>ein Ring hat keinen Teil</translation>
    </message>
    <message>
      <source>a ring's sizes make no teeth</source>
      <translation>die Maße eines Rings ergeben keine Zähne</translation>
    </message>
    <message>
      <source>a solid is open or no manifold</source>
      <translation>ein Körper ist offen oder keine Mannigfaltigkeit</translation>
    </message>
    <message>
      <source>a soluble slab can't be printed front side down: it lies on the bed beside the back pins</source>
      <translation>eine lösliche Platte lässt sich nicht mit der Vorderseite nach unten drucken: sie liegt neben den hinteren Zapfen auf dem Bett</translation>
    </message>
    <message>
      <source>a tolerance of {0} mm is out of range</source>
      <translation>eine Toleranz von {0} mm ist außerhalb des Bereichs</translation>
    </message>
    <message>
      <source>a vertex is not finite</source>
      <translation>ein Punkt ist nicht endlich</translation>
    </message>
    <message>
      <source>actuated tiles overlap by {value:.3g mm3} ({at})</source>
      <translation>Kacheln in Form überlappen um {value:.3g mm3} ({at})</translation>
    </message>
    <message>
      <source>all corners of the surface lie in one point</source>
      <translation>alle Ecken der Fläche liegen in einem Punkt</translation>
    </message>
    <message>
      <source>all tiles can be made</source>
      <translation>Alle Kacheln lassen sich herstellen</translation>
    </message>
    <message>
      <source>an export does not verify</source>
      <translation>Ein Export prüft nicht</translation>
    </message>
    <message>
      <source>an opening between parts that is none</source>
      <translation>eine Öffnung zwischen Teilen, die keine ist</translation>
    </message>
    <message>
      <source>an outline of no shapes</source>
      <translation>ein Umriss ohne Formen</translation>
    </message>
    <message>
      <source>another tau, or a smoother target near the tiles named, changes the membranes' pull there</source>
      <translation>ein anderes tau oder eine glattere Zielfläche nahe den genannten Kacheln ändert dort den Zug der Membranen</translation>
    </message>
    <message>
      <source>ask for fewer pieces, or lower L</source>
      <translation>weniger Stücke verlangen oder L verringern</translation>
    </message>
    <message>
      <source>back</source>
      <translation>hinten</translation>
    </message>
    <message>
      <source>back face / front face</source>
      <translation>Rückseite / Vorderseite</translation>
    </message>
    <message>
      <source>back membrane</source>
      <translation>hintere Membran</translation>
    </message>
    <message>
      <source>back pin</source>
      <translation>hinterer Zapfen</translation>
    </message>
    <message>
      <source>body</source>
      <translation>Körper</translation>
    </message>
    <message>
      <source>bridges enter tiles by {0} mm: into joint holes, behind {1} mm of wall (p_floor)</source>
      <translation>Brücken reichen {0} mm in Kacheln hinein: in Nählöcher hinter {1} mm Wand (p_floor)</translation>
    </message>
    <message>
      <source>bring tiles that lie far away back to the others</source>
      <translation>Kacheln, die weit entfernt liegen, zu den anderen zurückbringen</translation>
    </message>
    <message>
      <source>building bodies</source>
      <translation>Körper bauen</translation>
    </message>
    <message>
      <source>building solids</source>
      <translation>Volumenkörper bauen</translation>
    </message>
    <message>
      <source>building the support</source>
      <translation>Stützkörper bauen</translation>
    </message>
    <message>
      <source>building tiles</source>
      <translation>Kacheln bauen</translation>
    </message>
    <message>
      <source>bump</source>
      <translation>Noppe</translation>
    </message>
    <message>
      <source>bump_height ({0} mm) does not fit into the flat gap of d_gap_min ({1} mm)</source>
      <translation>bump_height ({0} mm) passt nicht in den flachen Spalt von d_gap_min ({1} mm)</translation>
    </message>
    <message>
      <source>bumps are {height:g mm} high, less than the {least:g mm} that a {printer} resolves</source>
      <translation>Noppen sind {height:g mm} hoch, weniger als die {least:g mm}, die ein {printer} auflöst</translation>
    </message>
    <message>
      <source>bumps stand into the gap between flat tiles, as walls are not recessed for their height: {left:.3g mm} of {asked:.3g mm} (d_gap_min) are left</source>
      <translation>Noppen ragen in den Spalt zwischen flachen Kacheln, da Wände für ihre Höhe nicht zurückstehen: {left:.3g mm} von {asked:.3g mm} (d_gap_min) bleiben</translation>
    </message>
    <message>
      <source>bumps would touch the neighbour in the flat layout</source>
      <translation>Noppen würden in der Abwicklung den Nachbarn berühren</translation>
    </message>
    <message>
      <source>can't write {0}: {1}</source>
      <translation>{0} lässt sich nicht schreiben: {1}</translation>
    </message>
    <message>
      <source>check contact points and forces for numbers that are not finite</source>
      <translation>Kontaktpunkte und Kräfte auf Zahlen überprüfen, die nicht endlich sind</translation>
    </message>
    <message>
      <source>check its name</source>
      <translation>prüfen, ob der Name stimmt</translation>
    </message>
    <message>
      <source>check its name and permissions</source>
      <translation>Name und Rechte überprüfen</translation>
    </message>
    <message>
      <source>check that the folder exists, is writable and that the disk has room</source>
      <translation>überprüfen, ob es den Ordner gibt, ob man in ihn schreiben kann und ob der Datenträger Platz hat</translation>
    </message>
    <message>
      <source>check the cuts</source>
      <translation>Schnitte prüfen</translation>
    </message>
    <message>
      <source>check the design for degenerate tiles</source>
      <translation>den Entwurf auf entartete Kacheln überprüfen</translation>
    </message>
    <message>
      <source>check the design's parameters</source>
      <translation>die Parameter des Entwurfs überprüfen</translation>
    </message>
    <message>
      <source>check the file and its format</source>
      <translation>Datei und Format überprüfen</translation>
    </message>
    <message>
      <source>check the file, and the transformations in it</source>
      <translation>die Datei und die Transformationen darin überprüfen</translation>
    </message>
    <message>
      <source>check the layout for bodies that overlap</source>
      <translation>die Abwicklung auf überlappende Körper überprüfen</translation>
    </message>
    <message>
      <source>check the layout's lengths against L</source>
      <translation>die Längen der Abwicklung mit L vergleichen</translation>
    </message>
    <message>
      <source>check the unit of the file (scale), or choose a larger L</source>
      <translation>die Einheit der Datei überprüfen (scale) oder ein größeres L wählen</translation>
    </message>
    <message>
      <source>checking solids</source>
      <translation>Volumenkörper prüfen</translation>
    </message>
    <message>
      <source>checking the target</source>
      <translation>Zielfläche untersuchen</translation>
    </message>
    <message>
      <source>checking tiles</source>
      <translation>Kacheln untersuchen</translation>
    </message>
    <message>
      <source>choose a Mesh or Part object with faces, or a file</source>
      <translation>ein Objekt von Mesh oder Part mit Flächen wählen, oder eine Datei</translation>
    </message>
    <message>
      <source>choose a body and a format</source>
      <translation>einen Körper und ein Format wählen</translation>
    </message>
    <message>
      <source>choose a folder you may write to</source>
      <translation>einen Ordner wählen, in den Sie schreiben dürfen</translation>
    </message>
    <message>
      <source>choose a smaller L, or fill the hole</source>
      <translation>ein kleineres L wählen oder das Loch füllen</translation>
    </message>
    <message>
      <source>choose a smaller L, or remove the part</source>
      <translation>ein kleineres L wählen oder den Teil entfernen</translation>
    </message>
    <message>
      <source>choose a surface with the Target command</source>
      <translation>mit „Zielfläche ändern“ eine Fläche wählen</translation>
    </message>
    <message>
      <source>choose one of {0}</source>
      <translation>eines davon wählen: {0}</translation>
    </message>
    <message>
      <source>clean the mesh first</source>
      <translation>das Netz zuerst säubern</translation>
    </message>
    <message>
      <source>clearance of the back membrane, mm</source>
      <translation>Abstand der Membran hinten, mm</translation>
    </message>
    <message>
      <source>clearance of the front membrane, mm</source>
      <translation>Abstand der Membran vorn, mm</translation>
    </message>
    <message>
      <source>compute the layout again with these parameters, or lower H_body</source>
      <translation>die Abwicklung mit diesen Parametern neu berechnen oder H_body verringern</translation>
    </message>
    <message>
      <source>compute the layout again, lower A_pin_floor or H_body, raise L, or set joint to none</source>
      <translation>die Abwicklung neu berechnen, A_pin_floor oder H_body verringern, L erhöhen oder joint auf none setzen</translation>
    </message>
    <message>
      <source>compute the layout again, or set support to breakaway</source>
      <translation>die Abwicklung neu berechnen oder support auf breakaway setzen</translation>
    </message>
    <message>
      <source>contact {contact} has {share:.2f} of f_min: {why}</source>
      <translation>Kontakt {contact} hat {share:.2f} von f_min: {why}</translation>
    </message>
    <message>
      <source>contact {contact} keeps pushing forces within friction at {share:.2f} of f_min: {why}</source>
      <translation>Kontakt {contact} hält drückende Kräfte mit Reibung bei {share:.2f} von f_min: {why}</translation>
    </message>
    <message>
      <source>contacts can't hold {held:8}: a hinge or nothing at all carries them</source>
      <translation>Kontakte können {held:8} nicht halten: nur ein Scharnier oder gar nichts trägt sie</translation>
    </message>
    <message>
      <source>coordinates are beyond 1e8 mm, where files lose all digits</source>
      <translation>Koordinaten liegen jenseits von 1e8 mm, wo Dateien alle Stellen verlieren</translation>
    </message>
    <message>
      <source>coordinates reach {largest:.4g mm}, where files lose digits</source>
      <translation>Koordinaten reichen bis {largest:.4g mm}, wo Dateien Stellen verlieren</translation>
    </message>
    <message>
      <source>corners of its border have moved too far</source>
      <translation>Ecken seines Randes haben sich zu weit bewegt</translation>
    </message>
    <message>
      <source>cut each handle open (--auto-cuts 1 or pieces=auto does)</source>
      <translation>jeden Henkel aufschneiden (--auto-cuts 1 oder pieces=auto tut das)</translation>
    </message>
    <message>
      <source>cut it as suggested</source>
      <translation>es schneiden wie vorgeschlagen</translation>
    </message>
    <message>
      <source>cut it at a plane (open=z&gt;0), or give cuts</source>
      <translation>sie an einer Ebene aufschneiden (open=z&gt;0) oder Schnitte angeben</translation>
    </message>
    <message>
      <source>cut it open (--auto-cuts 1 or pieces=auto does)</source>
      <translation>sie aufschneiden (--auto-cuts 1 oder pieces=auto tut das)</translation>
    </message>
    <message>
      <source>cut the band through, or model it with two sides</source>
      <translation>das Band durchschneiden oder mit zwei Seiten modellieren</translation>
    </message>
    <message>
      <source>cut {0} ({1}, {2}) is no interior edge of the mesh</source>
      <translation>Schnitt {0} ({1}, {2}) ist keine innere Kante des Netzes</translation>
    </message>
    <message>
      <source>cuts could not be looked for: {error}</source>
      <translation>Schnitte konnten nicht gesucht werden: {error}</translation>
    </message>
    <message>
      <source>design file: field {0} {1}</source>
      <translation>Entwurfsdatei: Feld {0} {1}</translation>
    </message>
    <message>
      <source>design file: not JSON ({0})</source>
      <translation>Entwurfsdatei: kein JSON ({0})</translation>
    </message>
    <message>
      <source>design file: not a JSON object</source>
      <translation>Entwurfsdatei: kein JSON-Objekt</translation>
    </message>
    <message>
      <source>design: {0} {1}</source>
      <translation>Entwurf: {0} {1}</translation>
    </message>
    <message>
      <source>dihedral margin, deg</source>
      <translation>Spielraum des Diederwinkels, Grad</translation>
    </message>
    <message>
      <source>dimples are {clearance:g mm} wider than bumps, less than the {least:g mm} that a {printer} resolves</source>
      <translation>Mulden sind {clearance:g mm} weiter als Noppen, weniger als die {least:g mm}, die ein {printer} auflöst</translation>
    </message>
    <message>
      <source>dividing into 1 piece</source>
      <translation>in 1 Stück teilen</translation>
    </message>
    <message>
      <source>dividing into pieces</source>
      <translation>in Stücke teilen</translation>
    </message>
    <message>
      <source>dividing into {0} pieces</source>
      <translation>in {0} Stücke teilen</translation>
    </message>
    <message>
      <source>dividing the print among beds</source>
      <translation>Druck auf Druckbetten aufteilen</translation>
    </message>
    <message>
      <source>dividing the support's lid</source>
      <translation>Deckel des Stützkörpers teilen</translation>
    </message>
    <message>
      <source>dividing the support's underside</source>
      <translation>Unterseite des Stützkörpers teilen</translation>
    </message>
    <message>
      <source>drawing pictures</source>
      <translation>Bilder zeichnen</translation>
    </message>
    <message>
      <source>earlier does not fit the tiles</source>
      <translation>earlier passt nicht zu den Kacheln</translation>
    </message>
    <message>
      <source>edges is no list of pairs of vertex numbers</source>
      <translation>edges ist keine Liste von Paaren von Punktnummern</translation>
    </message>
    <message>
      <source>export it again, as a surface of triangles</source>
      <translation>sie erneut exportieren, als Fläche aus Dreiecken</translation>
    </message>
    <message>
      <source>export the file again</source>
      <translation>die Datei erneut exportieren</translation>
    </message>
    <message>
      <source>export the surface itself</source>
      <translation>die Fläche selbst exportieren</translation>
    </message>
    <message>
      <source>f_min is the estimated error of the membrane mesh, which is more than f_min_ratio asks for</source>
      <translation>f_min ist der geschätzte Fehler des Membrannetzes, und der ist größer, als f_min_ratio verlangt</translation>
    </message>
    <message>
      <source>face {0} names a vertex that does not exist</source>
      <translation>Dreieck {0} nennt einen Punkt, den es nicht gibt</translation>
    </message>
    <message>
      <source>face {0} of the surface has an edge of {1} mm, L is {2} mm</source>
      <translation>Dreieck {0} der Fläche hat eine Kante von {1} mm, L ist {2} mm</translation>
    </message>
    <message>
      <source>face {0} of the surface has no area</source>
      <translation>Dreieck {0} der Fläche hat keinen Flächeninhalt</translation>
    </message>
    <message>
      <source>face {0} uses a vertex twice</source>
      <translation>Dreieck {0} verwendet einen Punkt zweimal</translation>
    </message>
    <message>
      <source>faces turned over</source>
      <translation>gewendete Flächen</translation>
    </message>
    <message>
      <source>fill the gap or widen it</source>
      <translation>die Lücke füllen oder verbreitern</translation>
    </message>
    <message>
      <source>flat tiles are {violation:.3g mm} nearer than d_gap_min</source>
      <translation>Flache Kacheln sind um {violation:.3g mm} näher als d_gap_min</translation>
    </message>
    <message>
      <source>flat tiles are {violation:.3g mm} nearer than d_gap_min ({pairs:6})</source>
      <translation>Flache Kacheln sind um {violation:.3g mm} näher als d_gap_min ({pairs:6})</translation>
    </message>
    <message>
      <source>flatten each by itself</source>
      <translation>jede für sich abwickeln</translation>
    </message>
    <message>
      <source>fold of {radius:.2g mm} radius at {tile}: {least:.2g mm} would do at L {L:.4g mm}, H_body {H_body:g mm}</source>
      <translation>Falte mit {radius:.2g mm} Radius an {tile}: {least:.2g mm} würden genügen bei L {L:.4g mm}, H_body {H_body:g mm}</translation>
    </message>
    <message>
      <source>folds and neighbours leave no room for pins on {0}{1}</source>
      <translation>Falten und Nachbarn lassen keinen Platz für Zapfen auf {0}{1}</translation>
    </message>
    <message>
      <source>folds are too sharp for tiles of this thickness: {0} back faces vanish</source>
      <translation>Falten sind zu scharf für Kacheln dieser Dicke: {0} Rückseiten verschwinden</translation>
    </message>
    <message>
      <source>following the surface</source>
      <translation>folgt der Fläche</translation>
    </message>
    <message>
      <source>friction and unilateral contacts</source>
      <translation>Reibung und einseitige Kontakte</translation>
    </message>
    <message>
      <source>front</source>
      <translation>vorn</translation>
    </message>
    <message>
      <source>front membrane</source>
      <translation>vordere Membran</translation>
    </message>
    <message>
      <source>front pin</source>
      <translation>vorderer Zapfen</translation>
    </message>
    <message>
      <source>gap</source>
      <translation>Spalt</translation>
    </message>
    <message>
      <source>geometry changed since verification</source>
      <translation>Die Geometrie hat sich seit dem Prüfen geändert</translation>
    </message>
    <message>
      <source>give 0 to 10 mm</source>
      <translation>0 bis 10 mm angeben</translation>
    </message>
    <message>
      <source>give 0.0001 to 1 mm</source>
      <translation>0.0001 bis 1 mm angeben</translation>
    </message>
    <message>
      <source>give L in mm</source>
      <translation>L in mm angeben</translation>
    </message>
    <message>
      <source>give [[[x,y,z],...],...] in mm</source>
      <translation>[[[x,y,z],...],...] in mm angeben</translation>
    </message>
    <message>
      <source>give [[a,b],...]</source>
      <translation>[[a,b],...] angeben</translation>
    </message>
    <message>
      <source>give a design.json of 'curveups design'</source>
      <translation>ein design.json von „curveups design“ angeben</translation>
    </message>
    <message>
      <source>give a file that 'curveups design' wrote</source>
      <translation>eine Datei angeben, die „curveups design“ geschrieben hat</translation>
    </message>
    <message>
      <source>give a file, or a built-in name from 'curveups targets'</source>
      <translation>eine Datei angeben oder einen Namen aus „curveups targets“</translation>
    </message>
    <message>
      <source>give a frame of this design</source>
      <translation>ein Bild dieses Entwurfs angeben</translation>
    </message>
    <message>
      <source>give a number, a text or true or false</source>
      <translation>eine Zahl, einen Text, true oder false angeben</translation>
    </message>
    <message>
      <source>give a row for each tile</source>
      <translation>für jede Kachel eine Zeile angeben</translation>
    </message>
    <message>
      <source>give a target</source>
      <translation>eine Zielfläche angeben</translation>
    </message>
    <message>
      <source>give another plane with open</source>
      <translation>mit open eine andere Ebene angeben</translation>
    </message>
    <message>
      <source>give another plane, or one side of it (open={0}&gt;{1})</source>
      <translation>eine andere Ebene angeben, oder eine ihrer Seiten (open={0}&gt;{1})</translation>
    </message>
    <message>
      <source>give arrays that belong together, lengths in mm</source>
      <translation>zusammengehörige Felder angeben, Längen in mm</translation>
    </message>
    <message>
      <source>give auto, largest, none, or a plane as z=0, z&gt;0 or x&lt;12.5</source>
      <translation>auto, largest, none oder eine Ebene wie z=0, z&gt;0 oder x&lt;12.5 angeben</translation>
    </message>
    <message>
      <source>give auto, or a whole number from 1 to 24</source>
      <translation>auto oder eine ganze Zahl von 1 bis 24 angeben</translation>
    </message>
    <message>
      <source>give corners in order, without crossings</source>
      <translation>Ecken der Reihe nach angeben, ohne Überkreuzungen</translation>
    </message>
    <message>
      <source>give cuts as polylines, or L as a number</source>
      <translation>Schnitte als Linienzüge angeben oder L als Zahl</translation>
    </message>
    <message>
      <source>give each tile its part, from 0 on</source>
      <translation>jeder Kachel ihr Teil geben, von 0 an</translation>
    </message>
    <message>
      <source>give edges or polylines</source>
      <translation>edges oder polylines angeben</translation>
    </message>
    <message>
      <source>give it an outline</source>
      <translation>ihm einen Umriss geben</translation>
    </message>
    <message>
      <source>give its corners counter-clockwise, in mm</source>
      <translation>seine Ecken gegen den Uhrzeigersinn angeben, in mm</translation>
    </message>
    <message>
      <source>give its outline</source>
      <translation>seinen Umriss angeben</translation>
    </message>
    <message>
      <source>give mend_max in mm</source>
      <translation>mend_max in mm angeben</translation>
    </message>
    <message>
      <source>give name=value</source>
      <translation>name=value angeben</translation>
    </message>
    <message>
      <source>give one a point</source>
      <translation>eines je Punkt angeben</translation>
    </message>
    <message>
      <source>give one of the choices of membrane_model</source>
      <translation>eine der Möglichkeiten von membrane_model angeben</translation>
    </message>
    <message>
      <source>give one of {0}</source>
      <translation>eins von {0} angeben</translation>
    </message>
    <message>
      <source>give one within the range that 'curveups parameters' says</source>
      <translation>einen Wert im Bereich angeben, den „curveups parameters“ nennt</translation>
    </message>
    <message>
      <source>give pairs of neighbouring vertices of the remeshed target</source>
      <translation>Paare benachbarter Punkte der neu vernetzten Zielfläche angeben</translation>
    </message>
    <message>
      <source>give places in mm</source>
      <translation>Orte in mm angeben</translation>
    </message>
    <message>
      <source>give points, one a line</source>
      <translation>Punkte angeben, einen je Zeile</translation>
    </message>
    <message>
      <source>give some of 0 to {0}</source>
      <translation>einige von 0 bis {0} angeben</translation>
    </message>
    <message>
      <source>give some of {0} to {1}</source>
      <translation>einige von {0} bis {1} angeben</translation>
    </message>
    <message>
      <source>give step, stl or 3mf</source>
      <translation>step, stl oder 3mf angeben</translation>
    </message>
    <message>
      <source>give teeth that are higher than wide</source>
      <translation>Zähne angeben, die höher als breit sind</translation>
    </message>
    <message>
      <source>give the points in mm, on the surface</source>
      <translation>die Punkte in mm angeben, auf der Fläche</translation>
    </message>
    <message>
      <source>give the target that the mesh was moved away from</source>
      <translation>die Zielfläche angeben, von der das Netz wegbewegt wurde</translation>
    </message>
    <message>
      <source>give them in mm</source>
      <translation>sie in mm angeben</translation>
    </message>
    <message>
      <source>give tiles, support, anchors, print or actuated</source>
      <translation>tiles, support, anchors, print oder actuated angeben</translation>
    </message>
    <message>
      <source>give two or more</source>
      <translation>zwei oder mehr angeben</translation>
    </message>
    <message>
      <source>give x y z in mm, of markers with the tile's name before it</source>
      <translation>x y z in mm angeben, bei Marken mit dem Namen der Kachel davor</translation>
    </message>
    <message>
      <source>give x, y, z in mm and a unit quaternion w, x, y, z</source>
      <translation>x, y, z in mm und eine Einheitsquaternion w, x, y, z angeben</translation>
    </message>
    <message>
      <source>give {0} file</source>
      <translation>eine Datei angeben: {0}</translation>
    </message>
    <message>
      <source>give {0} or more that are not on a line</source>
      <translation>{0} oder mehr angeben, die nicht auf einer Geraden liegen</translation>
    </message>
    <message>
      <source>give {0} to {1}</source>
      <translation>{0} bis {1} angeben</translation>
    </message>
    <message>
      <source>height of the pins</source>
      <translation>Höhe der Zapfen</translation>
    </message>
    <message>
      <source>held_tiles names {0}, but there are {1} tiles</source>
      <translation>held_tiles nennt {0}, aber es gibt {1} Kacheln</translation>
    </message>
    <message>
      <source>inset at its limit</source>
      <translation>Zapfenkante an ihrer Grenze</translation>
    </message>
    <message>
      <source>install CurveUps again, or run tools/setup in a checkout</source>
      <translation>CurveUps erneut installieren, oder tools/setup in einem Checkout ausführen</translation>
    </message>
    <message>
      <source>install FreeCAD whole</source>
      <translation>FreeCAD vollständig installieren</translation>
    </message>
    <message>
      <source>install FreeCAD, then run tools/setup again</source>
      <translation>FreeCAD installieren, dann tools/setup erneut ausführen</translation>
    </message>
    <message>
      <source>install it with pip into FreeCAD's Python; designs, solids, STEP, STL and 3MF do without</source>
      <translation>mit pip in FreeCADs Python installieren; Entwürfe, Körper, STEP, STL und 3MF brauchen es nicht</translation>
    </message>
    <message>
      <source>into the saddle at {tile}, which the flat map scales by {scale:.2g} of the mean</source>
      <translation>in den Sattel bei {tile}, den die flache Karte mit {scale:.2g} des Mittels skaliert</translation>
    </message>
    <message>
      <source>invalid</source>
      <translation>ungültig</translation>
    </message>
    <message>
      <source>is it in metres or inches? set scale (1000 or 25.4), or choose a smaller L</source>
      <translation>Ist sie in Metern oder Zoll? scale setzen (1000 oder 25.4) oder ein kleineres L wählen</translation>
    </message>
    <message>
      <source>it has another number of borders or holes</source>
      <translation>die Zahl seiner Ränder oder Löcher ist anders</translation>
    </message>
    <message>
      <source>it has another number of parts or handles</source>
      <translation>die Zahl seiner Teile oder Henkel ist anders</translation>
    </message>
    <message>
      <source>it has other creases</source>
      <translation>es hat andere Knicke</translation>
    </message>
    <message>
      <source>it runs through {other}, another part of the target, and no plane parts them</source>
      <translation>sie geht durch {other}, einen anderen Teil der Zielfläche, und keine Ebene trennt sie</translation>
    </message>
    <message>
      <source>it was not verified: Verify judges it</source>
      <translation>der Entwurf wurde nicht geprüft: „Prüfen“ beurteilt ihn</translation>
    </message>
    <message>
      <source>its first word has to be OFF</source>
      <translation>ihr erstes Wort muss OFF sein</translation>
    </message>
    <message>
      <source>its hollows would break into another face</source>
      <translation>ihre Mulden brächen in eine andere Fläche durch</translation>
    </message>
    <message>
      <source>its piece has no flat map: closed surfaces and handles have to be cut open first</source>
      <translation>ihr Stück lässt sich nicht flach auslegen: geschlossene Flächen und Henkel müssen zuerst aufgeschnitten werden</translation>
    </message>
    <message>
      <source>its shape has changed too much</source>
      <translation>seine Form hat sich zu sehr geändert</translation>
    </message>
    <message>
      <source>its {side} membrane would cut into it at a sharp corner or fold: pins rise {room:.2f mm} over it, {least:.2g mm} are wanted</source>
      <translation>ihre Membran ({side}) schnitte an einer scharfen Ecke oder Falte in sie: Zapfen stehen {room:.2f mm} über ihr, {least:.2g mm} sind verlangt</translation>
    </message>
    <message>
      <source>its {side} pin has room for {area:.3g mm2}, less than A_pin_floor ({least:g mm2})</source>
      <translation>ihr Zapfen ({side}) hat Platz für {area:.3g mm2}, weniger als A_pin_floor ({least:g mm2})</translation>
    </message>
    <message>
      <source>join them in the CAD, or name the faces to take (faces)</source>
      <translation>im CAD verbinden, oder die gewünschten Flächen nennen (faces)</translation>
    </message>
    <message>
      <source>joins the hole at {tile} to another boundary</source>
      <translation>verbindet das Loch bei {tile} mit einem anderen Rand</translation>
    </message>
    <message>
      <source>joint hole</source>
      <translation>Nähloch</translation>
    </message>
    <message>
      <source>joint=holes, but no two pieces have a border in common: there is nothing to join</source>
      <translation>joint=holes, aber keine zwei Stücke haben einen gemeinsamen Rand: nichts ist zu verbinden</translation>
    </message>
    <message>
      <source>keep each polyline on one component</source>
      <translation>jeden Linienzug auf einem Teil lassen</translation>
    </message>
    <message>
      <source>lay the target out anew</source>
      <translation>die Zielfläche neu abwickeln</translation>
    </message>
    <message>
      <source>lay these tiles out without overlap</source>
      <translation>diese Kacheln ohne Überlappung auslegen</translation>
    </message>
    <message>
      <source>layout</source>
      <translation>Abwicklung</translation>
    </message>
    <message>
      <source>leave one of them out</source>
      <translation>eines davon weglassen</translation>
    </message>
    <message>
      <source>leave out the cut there, or cut elsewhere</source>
      <translation>den Schnitt dort weglassen oder anderswo schneiden</translation>
    </message>
    <message>
      <source>let it be cut open (--auto-cuts 1) or divided (pieces=auto), give --cuts, or remove a part of it</source>
      <translation>sie aufschneiden (--auto-cuts 1) oder teilen lassen (pieces=auto), --cuts angeben oder einen Teil entfernen</translation>
    </message>
    <message>
      <source>let the slicer put supports there, on the bed alone</source>
      <translation>den Slicer dort Stützen setzen lassen, nur auf dem Bett</translation>
    </message>
    <message>
      <source>let the slicer put supports there, on the bed alone; with orientation=front-up they come off once a membrane holds the tiles</source>
      <translation>den Slicer dort Stützen setzen lassen, nur auf dem Bett; mit orientation=front-up gehen sie ab, sobald eine Membran die Kacheln hält</translation>
    </message>
    <message>
      <source>let the target be remeshed</source>
      <translation>die Zielfläche neu vernetzen lassen</translation>
    </message>
    <message>
      <source>list them with 'curveups parameters'</source>
      <translation>„curveups parameters“ führt sie auf</translation>
    </message>
    <message>
      <source>look for a vertex far away from the others, or choose a larger L</source>
      <translation>nach einem Punkt weit weg von den anderen suchen oder ein größeres L wählen</translation>
    </message>
    <message>
      <source>look for bodies that overlap: compute the layout again</source>
      <translation>nach Körpern suchen, die sich überschneiden: das Layout neu berechnen</translation>
    </message>
    <message>
      <source>looking for cuts</source>
      <translation>Schnitte suchen</translation>
    </message>
    <message>
      <source>lower A_pin_floor or H_body, raise L, or set joint to none</source>
      <translation>A_pin_floor oder H_body verringern, L erhöhen oder joint auf none setzen</translation>
    </message>
    <message>
      <source>lower A_pin_floor or raise A_pin_min</source>
      <translation>A_pin_floor verringern oder A_pin_min erhöhen</translation>
    </message>
    <message>
      <source>lower H_body or bump_height, or flatten the folds there</source>
      <translation>H_body oder bump_height verringern oder die Falten dort abflachen</translation>
    </message>
    <message>
      <source>lower H_body or p_min, raise L, or smooth the target there (mend=on)</source>
      <translation>H_body oder p_min verringern, L erhöhen oder die Zielfläche dort glätten (mend=on)</translation>
    </message>
    <message>
      <source>lower H_body or smooth the target there (mend=on)</source>
      <translation>H_body verringern oder die Zielfläche dort glätten (mend=on)</translation>
    </message>
    <message>
      <source>lower H_body, or keep parts of the target farther from one another</source>
      <translation>H_body verringern oder Teile der Zielfläche weiter von einander entfernen</translation>
    </message>
    <message>
      <source>lower H_body, p_min or A_pin_min, raise L or smooth the target there (mend=on)</source>
      <translation>H_body, p_min oder A_pin_min verringern, L erhöhen oder die Zielfläche dort glätten (mend=on)</translation>
    </message>
    <message>
      <source>lower H_body, raise L or smooth the target there (mend=on)</source>
      <translation>H_body verringern, L erhöhen oder die Zielfläche dort glätten (mend=on)</translation>
    </message>
    <message>
      <source>lower L, or give edges that tiles must meet a crease_angle</source>
      <translation>L verringern, oder mit crease_angle die Kanten halten, denen Kacheln folgen müssen</translation>
    </message>
    <message>
      <source>lower anchor_radius, or compute the layout again</source>
      <translation>anchor_radius verringern oder die Abwicklung neu berechnen</translation>
    </message>
    <message>
      <source>lower bump_height or raise d_gap_min</source>
      <translation>bump_height verringern oder d_gap_min erhöhen</translation>
    </message>
    <message>
      <source>lower p_min or raise p_max</source>
      <translation>p_min verringern oder p_max erhöhen</translation>
    </message>
    <message>
      <source>lower their insets</source>
      <translation>sie weniger zurücksetzen</translation>
    </message>
    <message>
      <source>make the normals consistent</source>
      <translation>die Normalen einheitlich ausrichten</translation>
    </message>
    <message>
      <source>making room for pins</source>
      <translation>Platz für Zapfen schaffen</translation>
    </message>
    <message>
      <source>measuring bodies</source>
      <translation>Körper vermessen</translation>
    </message>
    <message>
      <source>measuring clearances</source>
      <translation>Abstände messen</translation>
    </message>
    <message>
      <source>measuring deviation</source>
      <translation>Abweichung messen</translation>
    </message>
    <message>
      <source>membrane</source>
      <translation>Membran</translation>
    </message>
    <message>
      <source>mend that, or insist on the files</source>
      <translation>das beheben oder auf den Dateien bestehen</translation>
    </message>
    <message>
      <source>mend the file</source>
      <translation>die Datei reparieren</translation>
    </message>
    <message>
      <source>mend the surface, or export it as a mesh</source>
      <translation>die Fläche reparieren oder als Netz exportieren</translation>
    </message>
    <message>
      <source>mending left {at:6} with too little room for pins or under membranes</source>
      <translation>Das Ausbessern ließ {at:6} zu wenig Platz für Zapfen oder unter Membranen</translation>
    </message>
    <message>
      <source>mending the target</source>
      <translation>Zielfläche ausbessern</translation>
    </message>
    <message>
      <source>mesh the layout again</source>
      <translation>die Abwicklung neu vernetzen</translation>
    </message>
    <message>
      <source>meshing bodies</source>
      <translation>Körper vernetzen</translation>
    </message>
    <message>
      <source>meshing membranes</source>
      <translation>Membranen vernetzen</translation>
    </message>
    <message>
      <source>more than 1 % of the membranes is stretched by {elongation:.3g} % or more, beyond elongation_at_break ({limit:.3g} %): they tear; lower tau</source>
      <translation>Mehr als 1 % der Membranen ist um {elongation:.3g} % oder mehr gedehnt, über elongation_at_break ({limit:.3g} %) hinaus: sie reißen; tau verringern</translation>
    </message>
    <message>
      <source>move the cut inside the surface</source>
      <translation>den Schnitt ins Innere der Fläche verlegen</translation>
    </message>
    <message>
      <source>move the surface to the origin, or check its unit (scale)</source>
      <translation>die Fläche zum Ursprung verschieben oder ihre Einheit überprüfen (scale)</translation>
    </message>
    <message>
      <source>name another folder with -o</source>
      <translation>mit -o einen anderen Ordner nennen</translation>
    </message>
    <message>
      <source>name faces as FreeCAD does, from 1: Face3,Face7-9</source>
      <translation>Flächen nennen, wie FreeCAD es tut, ab 1: Face3,Face7-9</translation>
    </message>
    <message>
      <source>name it without slashes</source>
      <translation>ihn ohne Schrägstriche nennen</translation>
    </message>
    <message>
      <source>name the faces (--set faces=Face1,Face2), or leave skin at outer</source>
      <translation>die Flächen nennen (--set faces=Face1,Face2) oder skin auf outer lassen</translation>
    </message>
    <message>
      <source>name the tiles of all markers, or of none</source>
      <translation>die Kacheln aller Marken nennen oder keiner</translation>
    </message>
    <message>
      <source>name tiles as reports do: T00012,T00345</source>
      <translation>Kacheln nennen, wie Berichte es tun: T00012,T00345</translation>
    </message>
    <message>
      <source>name tiles of this design</source>
      <translation>Kacheln dieses Entwurfs nennen</translation>
    </message>
    <message>
      <source>neighbouring faces are oriented differently at {0} edges (or the surface has one side only)</source>
      <translation>benachbarte Dreiecke sind an {0} Kanten verschieden ausgerichtet (oder die Fläche hat nur eine Seite)</translation>
    </message>
    <message>
      <source>no H_body was found at which all tiles can be made (at L {L:.4g mm})</source>
      <translation>Kein H_body gefunden, mit dem sich alle Kacheln herstellen lassen (bei L {L:.4g mm})</translation>
    </message>
    <message>
      <source>no L was found at which all tiles can be made (at H_body {H_body:g mm})</source>
      <translation>Kein L gefunden, mit dem sich alle Kacheln herstellen lassen (bei H_body {H_body:g mm})</translation>
    </message>
    <message>
      <source>no back face: its folds are too sharp for tiles of this thickness</source>
      <translation>keine Rückseite: ihre Falten sind zu scharf für Kacheln dieser Dicke</translation>
    </message>
    <message>
      <source>no cut runs along an interior edge</source>
      <translation>kein Schnitt verläuft entlang einer inneren Kante</translation>
    </message>
    <message>
      <source>no cut was found that is worth it</source>
      <translation>kein Schnitt fand sich, der sich lohnt</translation>
    </message>
    <message>
      <source>no design with the sizes that were tried is valid</source>
      <translation>Kein Entwurf mit den versuchten Größen ist gültig</translation>
    </message>
    <message>
      <source>no division into up to {0} pieces lies flat</source>
      <translation>keine Teilung in bis zu {0} Stücke liegt flach</translation>
    </message>
    <message>
      <source>no division into up to {most} pieces has as little stretch as membranes bear; the best has {count}</source>
      <translation>Keine Teilung in bis zu {most} Stücke hat so wenig Verzerrung, wie Membranen aushalten; die beste hat {count}</translation>
    </message>
    <message>
      <source>no file is chosen</source>
      <translation>keine Datei ist gewählt</translation>
    </message>
    <message>
      <source>no path of edges joins points {0} and {1} of the polyline</source>
      <translation>kein Weg aus Kanten verbindet die Punkte {0} und {1} des Linienzugs</translation>
    </message>
    <message>
      <source>no print file is called .{0}</source>
      <translation>keine Druckdatei heißt .{0}</translation>
    </message>
    <message>
      <source>no size was found that works: {0}</source>
      <translation>Keine Größe gefunden, die geht: {0}</translation>
    </message>
    <message>
      <source>no small change of layout, pins or vertices lifts it</source>
      <translation>keine kleine Änderung von Abwicklung, Zapfen oder Ecken hebt ihn</translation>
    </message>
    <message>
      <source>no such target</source>
      <translation>diese Zielfläche gibt es nicht</translation>
    </message>
    <message>
      <source>no volume</source>
      <translation>kein Volumen</translation>
    </message>
    <message>
      <source>not flat</source>
      <translation>nicht eben</translation>
    </message>
    <message>
      <source>notch of the bridge</source>
      <translation>Kerbe der Brücke</translation>
    </message>
    <message>
      <source>nothing carries the piece of {tile}: held_tiles names none of its tiles</source>
      <translation>Nichts trägt das Stück von {tile}: held_tiles nennt keine seiner Kacheln</translation>
    </message>
    <message>
      <source>nothing carries the piece of {tile}: it does not reach the ground, where the lowest piece rests</source>
      <translation>Nichts trägt das Stück von {tile}: es reicht nicht bis zum Boden, auf dem das tiefste Stück ruht</translation>
    </message>
    <message>
      <source>nothing of the part has {0} {1} {2}</source>
      <translation>nichts am Teil hat {0} {1} {2}</translation>
    </message>
    <message>
      <source>only {0} of the file's {1} faces could be read</source>
      <translation>nur {0} von {1} Flächen der Datei ließen sich lesen</translation>
    </message>
    <message>
      <source>open</source>
      <translation>offen</translation>
    </message>
    <message>
      <source>opens what is closed or has handles</source>
      <translation>öffnet, was geschlossen ist oder Henkel hat</translation>
    </message>
    <message>
      <source>out of date</source>
      <translation>veraltet</translation>
    </message>
    <message>
      <source>p_floor ({0} mm) leaves no wall around joint holes</source>
      <translation>p_floor ({0} mm) lässt keine Wand um Nählöcher</translation>
    </message>
    <message>
      <source>p_max gives way on {count} edges of pins, where folds ask for less than pins that face one another leave: from {before:.3g mm} to {after:.3g mm} at the {side} of {tile}</source>
      <translation>p_max gibt an {count} Zapfenkanten nach, wo Falten weniger verlangen, als gegenüberliegende Zapfen lassen: von {before:.3g mm} auf {after:.3g mm} an {tile} ({side})</translation>
    </message>
    <message>
      <source>p_min ({0} mm) is larger than p_max ({1} mm)</source>
      <translation>p_min ({0} mm) ist größer als p_max ({1} mm)</translation>
    </message>
    <message>
      <source>p_min gave way to {least:.3g mm} at {at:6}, below what a {printer} makes ({makes:g mm}): raise p_floor</source>
      <translation>p_min gab bis auf {least:.3g mm} nach an {at:6}, weniger, als ein {printer} macht ({makes:g mm}): p_floor erhöhen</translation>
    </message>
    <message>
      <source>p_min gives way on {count} edges of pins, where folds leave their pins no room: from {before:.3g mm} to {after:.3g mm} at the {side} of {tile}</source>
      <translation>p_min gibt an {count} Zapfenkanten nach, wo Falten ihren Zapfen keinen Platz lassen: von {before:.3g mm} auf {after:.3g mm} an {tile} ({side})</translation>
    </message>
    <message>
      <source>parameter {0} can't be a {1}</source>
      <translation>der Parameter {0} kann nicht {1} sein</translation>
    </message>
    <message>
      <source>parameter {0} can't be {1}</source>
      <translation>der Parameter {0} kann nicht {1} sein</translation>
    </message>
    <message>
      <source>parameter {0} can't have this value</source>
      <translation>der Parameter {0} kann diesen Wert nicht haben</translation>
    </message>
    <message>
      <source>parts of another number of tiles</source>
      <translation>Teile einer anderen Anzahl von Kacheln</translation>
    </message>
    <message>
      <source>parts of the surface touch in single vertices (vertices {vertices:#5})</source>
      <translation>Teile der Fläche berühren sich in einzelnen Ecken (Ecken {vertices:#5})</translation>
    </message>
    <message>
      <source>parts that it has already and cuts that are given count as well</source>
      <translation>Teile, die sie schon hat, und gegebene Schnitte zählen mit</translation>
    </message>
    <message>
      <source>pass a layout with tiles</source>
      <translation>eine Abwicklung mit Kacheln übergeben</translation>
    </message>
    <message>
      <source>pass finite numbers</source>
      <translation>endliche Zahlen übergeben</translation>
    </message>
    <message>
      <source>pass one row per tile</source>
      <translation>eine Zeile je Kachel übergeben</translation>
    </message>
    <message>
      <source>pick the edges again</source>
      <translation>die Kanten erneut wählen</translation>
    </message>
    <message>
      <source>piece {piece} by itself: a contact point of {contact} has {least:.3g N}, less than f_min = {f_min:.3g N} of this piece</source>
      <translation>Stück {piece} für sich: ein Kontaktpunkt von {contact} hat {least:.3g N}, weniger als f_min = {f_min:.3g N} dieses Stücks</translation>
    </message>
    <message>
      <source>pieces that are not in the print</source>
      <translation>Stücke, die nicht im Druck sind</translation>
    </message>
    <message>
      <source>pin area</source>
      <translation>Zapfenfläche</translation>
    </message>
    <message>
      <source>pin area margin back, mm2</source>
      <translation>Spielraum der Zapfenfläche hinten, mm2</translation>
    </message>
    <message>
      <source>pin area margin front, mm2</source>
      <translation>Spielraum der Zapfenfläche vorn, mm2</translation>
    </message>
    <message>
      <source>pin insets leave their bounds by {violation:.3g mm}</source>
      <translation>Zapfen verlassen ihre Grenzen um {violation:.3g mm}</translation>
    </message>
    <message>
      <source>pin keep-out</source>
      <translation>Sperrbereich der Zapfen</translation>
    </message>
    <message>
      <source>pins of A_pin_floor have no room at L {L:.4g mm}, H_body {H_body:g mm}, even where it is flat</source>
      <translation>für Stifte von A_pin_floor ist bei L {L:.4g mm}, H_body {H_body:g mm} kein Platz, auch wo es eben ist</translation>
    </message>
    <message>
      <source>pins of at least A_pin_floor ({A_pin_floor:.3g mm2}) leave no room for stitching holes of {joint_hole:.3g mm}</source>
      <translation>Zapfen von mindestens A_pin_floor ({A_pin_floor:.3g mm2}) lassen keinen Platz für Nählöcher von {joint_hole:.3g mm}</translation>
    </message>
    <message>
      <source>pins of {0} tiles are turned inside out or leave their face</source>
      <translation>Zapfen von {0} Kacheln sind umgestülpt oder verlassen ihre Fläche</translation>
    </message>
    <message>
      <source>placing anchors</source>
      <translation>Anker setzen</translation>
    </message>
    <message>
      <source>please report it</source>
      <translation>bitte melden Sie das</translation>
    </message>
    <message>
      <source>polyline {0} has a point {1} mm away from the target</source>
      <translation>Linienzug {0} hat einen Punkt, der {1} mm von der Zielfläche entfernt ist</translation>
    </message>
    <message>
      <source>pressed and let go, the tiles do not come to rest</source>
      <translation>angedrückt und losgelassen kommen die Kacheln nicht zur Ruhe</translation>
    </message>
    <message>
      <source>pressed over its former ({force_n:.3g N} a tile) and let go, it comes to rest {mean:.3g mm} from the target in the mean, {largest:.3g mm} at most; {open} of {count} contacts stay open</source>
      <translation>über die Form gedrückt ({force_n:.3g N} je Kachel) und losgelassen, kommt es im Mittel {mean:.3g mm} vom Ziel zur Ruhe, höchstens {largest:.3g mm}; {open} von {count} Kontakten bleiben offen</translation>
    </message>
    <message>
      <source>pressing</source>
      <translation>es wird gedrückt</translation>
    </message>
    <message>
      <source>process window</source>
      <translation>Toleranzfenster</translation>
    </message>
    <message>
      <source>pushing forces within friction {mu:.3g} leave a least normal force of {least:.3g N}, less than f_min = {f_min:.3g N}, first at {contacts:8}{more}</source>
      <translation>Drückende Kräfte mit der Reibung {mu:.3g} lassen eine kleinste Normalkraft von {least:.3g N}, weniger als f_min = {f_min:.3g N}, zuerst an {contacts:8}{more}</translation>
    </message>
    <message>
      <source>put everything in braces</source>
      <translation>alles in geschweifte Klammern setzen</translation>
    </message>
    <message>
      <source>put {body} into the names</source>
      <translation>{body} in die Namen setzen</translation>
    </message>
    <message>
      <source>raise H_body, or choose another support</source>
      <translation>H_body erhöhen oder einen anderen Stützkörper wählen</translation>
    </message>
    <message>
      <source>raise d_gap_min, or set support to breakaway</source>
      <translation>d_gap_min erhöhen oder support auf breakaway setzen</translation>
    </message>
    <message>
      <source>raise friction_coefficient, or choose bumps=dimples</source>
      <translation>friction_coefficient erhöhen oder bumps=dimples wählen</translation>
    </message>
    <message>
      <source>raise maximum_deviation, or see 'curveups check'</source>
      <translation>maximum_deviation erhöhen, oder siehe „curveups check“</translation>
    </message>
    <message>
      <source>raise mesh_deviation</source>
      <translation>mesh_deviation erhöhen</translation>
    </message>
    <message>
      <source>raise p_floor to {0} mm or more, or set joint to none</source>
      <translation>p_floor auf {0} mm oder mehr erhöhen oder joint auf none setzen</translation>
    </message>
    <message>
      <source>raise p_floor, or set support to soluble</source>
      <translation>p_floor erhöhen oder support auf soluble setzen</translation>
    </message>
    <message>
      <source>raise tau, or lower p_max so that pins pull more strongly</source>
      <translation>tau erhöhen oder p_max verringern, damit Zapfen stärker ziehen</translation>
    </message>
    <message>
      <source>reading the target</source>
      <translation>Zielfläche lesen</translation>
    </message>
    <message>
      <source>registering the scan</source>
      <translation>Scan ausrichten</translation>
    </message>
    <message>
      <source>relaxing</source>
      <translation>Entspannen</translation>
    </message>
    <message>
      <source>released and shaken, the piece is expected to lie {mean:.2g mm} from the target on average ({low:.2g mm} to {high:.2g mm}), {largest:.2g mm} at most; all contacts close. Pressed over the former it comes within {pressed:.2g mm}</source>
      <translation>losgelassen und gerüttelt, dürfte das Teil im Mittel {mean:.2g mm} vom Ziel liegen ({low:.2g mm} bis {high:.2g mm}), höchstens {largest:.2g mm}; alle Kontakte schließen. Über die Form gedrückt kommt es bis auf {pressed:.2g mm} heran</translation>
    </message>
    <message>
      <source>released and shaken, the piece is expected to lie {mean:.2g mm} from the target on average ({low:.2g mm} to {high:.2g mm}), {largest:.2g mm} at most; {open} of {count} contacts stay open. Pressed over the former it comes within {pressed:.2g mm}</source>
      <translation>losgelassen und gerüttelt, dürfte das Teil im Mittel {mean:.2g mm} vom Ziel liegen ({low:.2g mm} bis {high:.2g mm}), höchstens {largest:.2g mm}; {open} von {count} Kontakten bleiben offen. Über die Form gedrückt kommt es bis auf {pressed:.2g mm} heran</translation>
    </message>
    <message>
      <source>released, it comes to rest {mean:.3g mm} from the target in the mean, {largest:.3g mm} at most; {open} of {count} contacts stay open</source>
      <translation>losgelassen kommt es im Mittel {mean:.3g mm} vom Ziel zur Ruhe, höchstens {largest:.3g mm}; {open} von {count} Kontakten bleiben offen</translation>
    </message>
    <message>
      <source>released, the tiles do not come to rest</source>
      <translation>losgelassen kommen die Kacheln nicht zur Ruhe</translation>
    </message>
    <message>
      <source>releasing</source>
      <translation>Loslassen</translation>
    </message>
    <message>
      <source>remesh the surface</source>
      <translation>die Fläche neu vernetzen</translation>
    </message>
    <message>
      <source>remesh the surface: it has faces with next to no area</source>
      <translation>die Fläche neu vernetzen: sie hat Dreiecke fast ohne Flächeninhalt</translation>
    </message>
    <message>
      <source>remeshing</source>
      <translation>neu vernetzen</translation>
    </message>
    <message>
      <source>remeshing failed: {0}</source>
      <translation>das Vernetzen ist gescheitert: {0}</translation>
    </message>
    <message>
      <source>remove degenerate faces</source>
      <translation>entartete Dreiecke entfernen</translation>
    </message>
    <message>
      <source>remove degenerate faces or let the target be remeshed</source>
      <translation>entartete Dreiecke entfernen oder die Zielfläche neu vernetzen lassen</translation>
    </message>
    <message>
      <source>remove duplicate and inner faces</source>
      <translation>doppelte und innere Dreiecke entfernen</translation>
    </message>
    <message>
      <source>remove inner walls and doubled faces</source>
      <translation>innere Wände und doppelte Dreiecke entfernen</translation>
    </message>
    <message>
      <source>remove it, or choose another folder</source>
      <translation>sie entfernen oder einen anderen Ordner wählen</translation>
    </message>
    <message>
      <source>remove one from its Edges</source>
      <translation>eine aus Edges entfernen</translation>
    </message>
    <message>
      <source>remove the doubles</source>
      <translation>die doppelten entfernen</translation>
    </message>
    <message>
      <source>remove them, or remesh</source>
      <translation>sie entfernen oder neu vernetzen</translation>
    </message>
    <message>
      <source>repair can't begin: {error}</source>
      <translation>Die Reparatur kann nicht beginnen: {error}</translation>
    </message>
    <message>
      <source>repair ended early: {said}</source>
      <translation>Die Reparatur endete früh: {said}</translation>
    </message>
    <message>
      <source>repair the file</source>
      <translation>die Datei reparieren</translation>
    </message>
    <message>
      <source>repair the mesh</source>
      <translation>das Netz reparieren</translation>
    </message>
    <message>
      <source>repair the surface, or give a remeshed one and switch remeshing off</source>
      <translation>die Fläche reparieren, oder eine neu vernetzte angeben und das Vernetzen abschalten</translation>
    </message>
    <message>
      <source>repair the surface: tiles can't pass through one another</source>
      <translation>die Fläche reparieren: Kacheln können nicht durch einander gehen</translation>
    </message>
    <message>
      <source>repair: fresh membranes</source>
      <translation>Reparatur: neue Membranen</translation>
    </message>
    <message>
      <source>repair: friction needed</source>
      <translation>Reparatur: Reibungsbedarf</translation>
    </message>
    <message>
      <source>repair: {0} weak points</source>
      <translation>Reparatur: {0} schwache Punkte</translation>
    </message>
    <message>
      <source>report this</source>
      <translation>bitte melden Sie das</translation>
    </message>
    <message>
      <source>report this with the design file</source>
      <translation>bitte melden Sie das mit der Entwurfsdatei</translation>
    </message>
    <message>
      <source>restoring the layout</source>
      <translation>Abwicklung wiederherstellen</translation>
    </message>
    <message>
      <source>run 'curveups design' with it</source>
      <translation>„curveups design“ damit ausführen</translation>
    </message>
    <message>
      <source>run Solve</source>
      <translation>„Lösen“ ausführen</translation>
    </message>
    <message>
      <source>run Solve, or Cuts</source>
      <translation>„Lösen“ oder „Schnitte“ ausführen</translation>
    </message>
    <message>
      <source>run tools/setup</source>
      <translation>tools/setup ausführen</translation>
    </message>
    <message>
      <source>save it as text, or as STL or PLY</source>
      <translation>als Text speichern, oder als STL oder PLY</translation>
    </message>
    <message>
      <source>see '{0} --help'</source>
      <translation>siehe „{0} --help“</translation>
    </message>
    <message>
      <source>see FreeCAD's report view</source>
      <translation>siehe FreeCADs Ausgabefenster</translation>
    </message>
    <message>
      <source>separate faces that touch in one vertex only</source>
      <translation>Dreiecke trennen, die sich nur in einem Punkt berühren</translation>
    </message>
    <message>
      <source>separate the parts</source>
      <translation>die Teile trennen</translation>
    </message>
    <message>
      <source>set H_body={wall:.3g}</source>
      <translation>H_body={wall:.3g} setzen</translation>
    </message>
    <message>
      <source>set bumps to none</source>
      <translation>bumps auf none setzen</translation>
    </message>
    <message>
      <source>set bumps to none, or raise bump_height</source>
      <translation>bumps auf none setzen oder bump_height erhöhen</translation>
    </message>
    <message>
      <source>set mend=on ({actions})</source>
      <translation>mend=on setzen ({actions})</translation>
    </message>
    <message>
      <source>set mend_max above {most:g mm}, or another L or H_body</source>
      <translation>mend_max über {most:g mm} setzen, oder ein anderes L oder H_body</translation>
    </message>
    <message>
      <source>set orientation to front-up, or support to breakaway</source>
      <translation>orientation auf front-up setzen oder support auf breakaway</translation>
    </message>
    <message>
      <source>set pieces to a number, or cut the target (--cuts)</source>
      <translation>pieces auf eine Zahl setzen oder die Zielfläche schneiden (--cuts)</translation>
    </message>
    <message>
      <source>set pieces to a number, or raise L</source>
      <translation>pieces auf eine Zahl setzen oder L erhöhen</translation>
    </message>
    <message>
      <source>set pieces to auto or to 2 or more, or joint to none</source>
      <translation>pieces auf auto oder auf 2 oder mehr setzen, oder joint auf none</translation>
    </message>
    <message>
      <source>set support to breakaway</source>
      <translation>support auf breakaway setzen</translation>
    </message>
    <message>
      <source>settle</source>
      <translation>Tragverhalten</translation>
    </message>
    <message>
      <source>shaken ({taps} taps), it comes to rest {mean:.3g mm} from the target in the mean, {largest:.3g mm} at most; {open} of {count} contacts stay open</source>
      <translation>gerüttelt ({taps} Stöße) kommt es im Mittel {mean:.3g mm} vom Ziel zur Ruhe, höchstens {largest:.3g mm}; {open} von {count} Kontakten bleiben offen</translation>
    </message>
    <message>
      <source>shaken, the tiles do not come to rest</source>
      <translation>geschüttelt kommen die Kacheln nicht zur Ruhe</translation>
    </message>
    <message>
      <source>shaking</source>
      <translation>es wird gerüttelt</translation>
    </message>
    <message>
      <source>simplify the mesh</source>
      <translation>das Netz vereinfachen</translation>
    </message>
    <message>
      <source>simplify the part, or export it again or as a mesh</source>
      <translation>das Teil vereinfachen, erneut exportieren oder als Netz exportieren</translation>
    </message>
    <message>
      <source>smoothing the target</source>
      <translation>Zielfläche glätten</translation>
    </message>
    <message>
      <source>solids are not sound: {solids:; }</source>
      <translation>Volumenkörper sind fehlerhaft: {solids:; }</translation>
    </message>
    <message>
      <source>solids are not sound: {solids:; } and {more} more</source>
      <translation>Volumenkörper sind fehlerhaft: {solids:; } und {more} weitere</translation>
    </message>
    <message>
      <source>solids can't be built: {error}</source>
      <translation>Volumenkörper lassen sich nicht bauen: {error}</translation>
    </message>
    <message>
      <source>solids meet in the flat layout ({at})</source>
      <translation>Körper treffen sich in der Abwicklung ({at})</translation>
    </message>
    <message>
      <source>solve the design again</source>
      <translation>den Entwurf erneut lösen</translation>
    </message>
    <message>
      <source>some points have a tile's name and others have none</source>
      <translation>einige Punkte haben den Namen einer Kachel, andere keinen</translation>
    </message>
    <message>
      <source>split that vertex or fill the hole</source>
      <translation>diesen Punkt teilen oder das Loch füllen</translation>
    </message>
    <message>
      <source>stop or cancel that first</source>
      <translation>das zuerst anhalten oder abbrechen</translation>
    </message>
    <message>
      <source>stopped before all solids were checked</source>
      <translation>Angehalten, bevor alle Volumenkörper geprüft waren</translation>
    </message>
    <message>
      <source>stopped during {stage}</source>
      <translation>Angehalten während {stage}</translation>
    </message>
    <message>
      <source>stretch / least that leaves gaps</source>
      <translation>Dehnung / kleinste, die Spalte lässt</translation>
    </message>
    <message>
      <source>stretch / most before slack</source>
      <translation>Dehnung / größte, die straff hält</translation>
    </message>
    <message>
      <source>suggested: {what_to_do}</source>
      <translation>Vorschlag: {what_to_do}</translation>
    </message>
    <message>
      <source>take a stronger glue, raise A_pin_min or lower tau</source>
      <translation>einen stärkeren Kleber nehmen, A_pin_min erhöhen oder tau verringern</translation>
    </message>
    <message>
      <source>take the expression away</source>
      <translation>den Ausdruck entfernen</translation>
    </message>
    <message>
      <source>take vertex numbers from what 'curveups remesh' writes</source>
      <translation>Punktnummern aus dem nehmen, was „curveups remesh“ schreibt</translation>
    </message>
    <message>
      <source>the 3MF would have more than 4 GB, which slicers do not read</source>
      <translation>das 3MF hätte mehr als 4 GB, was Slicer nicht lesen</translation>
    </message>
    <message>
      <source>the boundary touches itself in single vertices (vertices {vertices:#5})</source>
      <translation>Der Rand berührt sich selbst in einzelnen Ecken (Ecken {vertices:#5})</translation>
    </message>
    <message>
      <source>the boundary touches itself in vertex {0}</source>
      <translation>der Rand berührt sich selbst im Punkt {0}</translation>
    </message>
    <message>
      <source>the conformal map could not be computed</source>
      <translation>die konforme Abbildung ließ sich nicht berechnen</translation>
    </message>
    <message>
      <source>the conformal map turned the surface over</source>
      <translation>die konforme Abbildung hat die Fläche umgewendet</translation>
    </message>
    <message>
      <source>the conformal map's system is not positive definite</source>
      <translation>das System der konformen Abbildung ist nicht positiv definit</translation>
    </message>
    <message>
      <source>the cuts changed since the layout was solved: Solve brings it up to date</source>
      <translation>die Schnitte haben sich seit der Abwicklung geändert: „Lösen“ bringt es auf den neuesten Stand</translation>
    </message>
    <message>
      <source>the design can't be read: {0}</source>
      <translation>der Entwurf lässt sich nicht lesen: {0}</translation>
    </message>
    <message>
      <source>the design could not be verified: {error}</source>
      <translation>Der Entwurf konnte nicht geprüft werden: {error}</translation>
    </message>
    <message>
      <source>the design is no text</source>
      <translation>der Entwurf ist kein Text</translation>
    </message>
    <message>
      <source>the design is {state}: {reasons:; }</source>
      <translation>Der Entwurf ist {state}: {reasons:; }</translation>
    </message>
    <message>
      <source>the design was not verified</source>
      <translation>Der Entwurf wurde nicht geprüft</translation>
    </message>
    <message>
      <source>the design's target has other vertices than its mesh</source>
      <translation>die Zielfläche des Entwurfs hat andere Punkte als sein Netz</translation>
    </message>
    <message>
      <source>the document's {0} can't be computed</source>
      <translation>{0} des Dokuments lässt sich nicht berechnen</translation>
    </message>
    <message>
      <source>the file can't be read: {0}</source>
      <translation>die Datei lässt sich nicht lesen: {0}</translation>
    </message>
    <message>
      <source>the file does not hold a JSON object</source>
      <translation>die Datei enthält kein JSON-Objekt</translation>
    </message>
    <message>
      <source>the file ends early</source>
      <translation>die Datei endet zu früh</translation>
    </message>
    <message>
      <source>the file ends early, or is none of its format</source>
      <translation>die Datei endet zu früh oder hat ein anderes Format</translation>
    </message>
    <message>
      <source>the file holds no faces</source>
      <translation>die Datei enthält keine Flächen</translation>
    </message>
    <message>
      <source>the file holds no surface</source>
      <translation>die Datei enthält keine Oberfläche</translation>
    </message>
    <message>
      <source>the file is damaged: FreeCAD's reader crashed</source>
      <translation>die Datei ist beschädigt: beim Lesen stürzte FreeCAD ab</translation>
    </message>
    <message>
      <source>the flat map scales it by {stretch:.2f}; it can do with {low:.2f} to {high:.2f}: cuts would even that out</source>
      <translation>die flache Karte skaliert sie mit {stretch:.2f}; {low:.2f} bis {high:.2f} gingen: Schnitte glichen das aus</translation>
    </message>
    <message>
      <source>the forces on bodies in contact are not finite</source>
      <translation>die Kräfte auf Körper in Kontakt sind nicht endlich</translation>
    </message>
    <message>
      <source>the frame has poses of {0} tiles, the design has {1}</source>
      <translation>das Bild hat Lagen von {0} Kacheln, der Entwurf hat {1}</translation>
    </message>
    <message>
      <source>the frame's pose of {0} is no rigid motion</source>
      <translation>die Lage von {0} im Bild ist keine starre Bewegung</translation>
    </message>
    <message>
      <source>the front or back face of {0} tiles vanishes or turns inside out</source>
      <translation>Vorder- oder Rückseite von {0} Kacheln verschwindet oder stülpt sich um</translation>
    </message>
    <message>
      <source>the glue on pins of {overloaded:8} may let go: on the {side} pin of {tile} it carries {shear:.3g MPa} of shear, more than glue_strength ({limit:.3g MPa})</source>
      <translation>Der Kleber auf Zapfen von {overloaded:8} lässt vielleicht los: Am Zapfen ({side}) von {tile} trägt er {shear:.3g MPa} Schub, mehr als glue_strength ({limit:.3g MPa})</translation>
    </message>
    <message>
      <source>the layout breaks constraints that small steps can't restore</source>
      <translation>die Abwicklung verletzt Bedingungen, die kleine Schritte nicht wiederherstellen</translation>
    </message>
    <message>
      <source>the layout changed since this was built: BuildSolids brings it up to date</source>
      <translation>die Abwicklung hat sich geändert, seit dies gebaut wurde: „Volumenkörper bauen“ bringt es auf den neuesten Stand</translation>
    </message>
    <message>
      <source>the layout did not converge in {iterations} iterations</source>
      <translation>Die Abwicklung konvergierte nicht in {iterations} Iterationen</translation>
    </message>
    <message>
      <source>the layout did not converge in {iterations} iterations; all constraints hold</source>
      <translation>Die Abwicklung konvergierte nicht in {iterations} Iterationen; alle Nebenbedingungen gelten</translation>
    </message>
    <message>
      <source>the layout is badly stretched: its flat map scales tiles {spread:.3g} times differently, and the membrane is slack at {slack} places</source>
      <translation>Die Abwicklung ist stark verzerrt: ihre flache Karte skaliert Kacheln {spread:.3g}-fach verschieden, und die Membran ist an {slack} Stellen schlaff</translation>
    </message>
    <message>
      <source>the layout is {0} m wide</source>
      <translation>die Abwicklung ist {0} m breit</translation>
    </message>
    <message>
      <source>the least force exceeds f_min = {f_min:.3g N} by less than its error at {contacts:8}</source>
      <translation>bei {contacts:8} liegt die kleinste Kraft um weniger als ihren Fehler über f_min = {f_min:.3g N}</translation>
    </message>
    <message>
      <source>the line can't be read</source>
      <translation>die Zeile lässt sich nicht lesen</translation>
    </message>
    <message>
      <source>the list of cuts has an odd number of vertices</source>
      <translation>die Liste der Schnitte hat eine ungerade Anzahl von Punkten</translation>
    </message>
    <message>
      <source>the margin is not met: where the {side} membrane pulls {percent:.3g} % harder and friction is {mu:.3g}, no pushing forces balance the tiles: {pull:.3g N} of pull would be needed, first at {contacts:8}</source>
      <translation>Die Reserve ist nicht erfüllt: Wenn die Membran ({side}) um {percent:.3g} % stärker zieht und die Reibung {mu:.3g} ist, halten keine Druckkräfte die Kacheln im Gleichgewicht: {pull:.3g N} Zug wären nötig, zuerst bei {contacts:8}</translation>
    </message>
    <message>
      <source>the margin is not met: where the {side} membrane pulls {percent:.3g} % harder and friction is {mu:.3g}, pushing forces leave a least normal force of {least:.3g N}, less than f_min = {f_min:.3g N}, first at {contacts:8}</source>
      <translation>Die Reserve ist nicht erfüllt: Wenn die Membran ({side}) um {percent:.3g} % stärker zieht und die Reibung {mu:.3g} ist, lassen Druckkräfte eine kleinste Normalkraft von {least:.3g N}, weniger als f_min = {f_min:.3g N}, zuerst bei {contacts:8}</translation>
    </message>
    <message>
      <source>the margin is required, and the tiles did not settle: set run_settling and run_verification on</source>
      <translation>Die Reserve ist verlangt, und die Kacheln haben sich nicht gesetzt: run_settling und run_verification einschalten</translation>
    </message>
    <message>
      <source>the membranes do not press the tiles together</source>
      <translation>Die Membranen drücken die Kacheln nicht aneinander</translation>
    </message>
    <message>
      <source>the membranes' equilibrium was not reached (residual {residual:.3g})</source>
      <translation>Das Gleichgewicht der Membranen wurde nicht erreicht (Residuum {residual:.3g})</translation>
    </message>
    <message>
      <source>the mesh has more than {0} faces</source>
      <translation>das Netz hat mehr als {0} Dreiecke</translation>
    </message>
    <message>
      <source>the mesh's mean edge length is {0} mm</source>
      <translation>die mittlere Kantenlänge des Netzes ist {0} mm</translation>
    </message>
    <message>
      <source>the names '{0}' ask for {{1}}</source>
      <translation>die Namen „{0}“ fragen nach {{1}}</translation>
    </message>
    <message>
      <source>the names '{0}' can't be read: {1}</source>
      <translation>die Namen „{0}“ lassen sich nicht lesen: {1}</translation>
    </message>
    <message>
      <source>the native module can't be loaded: {0}</source>
      <translation>das native Modul lässt sich nicht laden: {0}</translation>
    </message>
    <message>
      <source>the native module has not been built</source>
      <translation>das native Modul wurde nicht gebaut</translation>
    </message>
    <message>
      <source>the native module is not for {0}</source>
      <translation>das native Modul ist nicht für {0}</translation>
    </message>
    <message>
      <source>the native module is of version {0}, not {1}</source>
      <translation>das native Modul hat Version {0}, nicht {1}</translation>
    </message>
    <message>
      <source>the object that gave the target was deleted: choose another with Target</source>
      <translation>das Objekt, von dem das Ziel kam, wurde gelöscht: mit „Ziel ändern“ ein anderes wählen</translation>
    </message>
    <message>
      <source>the outlines of a plane face cross or touch each other</source>
      <translation>die Umrisse einer ebenen Fläche kreuzen oder berühren einander</translation>
    </message>
    <message>
      <source>the output folder can't be made: {0}</source>
      <translation>der Ausgabeordner lässt sich nicht anlegen: {0}</translation>
    </message>
    <message>
      <source>the parameter table is missing</source>
      <translation>die Parametertabelle fehlt</translation>
    </message>
    <message>
      <source>the part has Face1 to Face{0}</source>
      <translation>das Teil hat Face1 bis Face{0}</translation>
    </message>
    <message>
      <source>the part has no planar face to leave open</source>
      <translation>das Teil hat keine ebene Fläche, die offen bleiben könnte</translation>
    </message>
    <message>
      <source>the part is drawn {wall:.3g mm} thick, tiles are {H_body:g mm} thick</source>
      <translation>Das Teil ist {wall:.3g mm} dick gezeichnet, Kacheln sind {H_body:g mm} dick</translation>
    </message>
    <message>
      <source>the path from flat was stopped before its end</source>
      <translation>der Weg vom flachen Zustand wurde vor seinem Ende angehalten</translation>
    </message>
    <message>
      <source>the piece of {tile} tips over on the table: its weight acts beside the corners on which it stands</source>
      <translation>das Stück von {tile} kippt auf dem Tisch: Sein Gewicht greift neben den Ecken an, auf denen es steht</translation>
    </message>
    <message>
      <source>the polyline has no points</source>
      <translation>der Linienzug hat keine Punkte</translation>
    </message>
    <message>
      <source>the print ({x:.0f mm} x {y:.0f mm} x {z:.0f mm}) is larger than the bed of a {printer}</source>
      <translation>Der Druck ({x:.0f mm} x {y:.0f mm} x {z:.0f mm}) ist größer als das Bett eines {printer}</translation>
    </message>
    <message>
      <source>the print can't be made: {error}</source>
      <translation>Der Druck lässt sich nicht machen: {error}</translation>
    </message>
    <message>
      <source>the saved results can't be read: {0}</source>
      <translation>die gespeicherten Ergebnisse lassen sich nicht lesen: {0}</translation>
    </message>
    <message>
      <source>the scan can't be read: there is no such file</source>
      <translation>der Scan ist nicht lesbar: die Datei gibt es nicht</translation>
    </message>
    <message>
      <source>the scan can't be read: {0}</source>
      <translation>der Scan lässt sich nicht lesen: {0}</translation>
    </message>
    <message>
      <source>the scan has more than {0} points</source>
      <translation>der Scan hat mehr als {0} Punkte</translation>
    </message>
    <message>
      <source>the scan is no text</source>
      <translation>der Scan ist kein Text</translation>
    </message>
    <message>
      <source>the shape does not hold: friction lets it drift by {drift:.3g mm}, more than hold_tolerance ({most:.3g mm})</source>
      <translation>Die Form hält nicht: die Reibung lässt sie um {drift:.3g mm} abdriften, mehr als hold_tolerance ({most:.3g mm})</translation>
    </message>
    <message>
      <source>the shape does not hold: the contacts {contacts:8} open as the tiles settle</source>
      <translation>Die Form hält nicht: die Kontakte {contacts:8} öffnen sich, wenn die Kacheln sich setzen</translation>
    </message>
    <message>
      <source>the slab's walls between tiles are as thin as {clearance:.3g mm}; a {printer} makes {least:g mm}</source>
      <translation>Die Wände der Platte zwischen Kacheln sind nur {clearance:.3g mm} dünn; ein {printer} macht {least:g mm}</translation>
    </message>
    <message>
      <source>the solids can't be united</source>
      <translation>die Volumenkörper lassen sich nicht vereinigen</translation>
    </message>
    <message>
      <source>the soluble slab is a second material; a {printer} prints one</source>
      <translation>Die lösliche Platte ist ein zweites Material; ein {printer} druckt eines</translation>
    </message>
    <message>
      <source>the sparse solver could not order a system of {0} unknowns</source>
      <translation>der dünnbesetzte Löser konnte ein System von {0} Unbekannten nicht ordnen</translation>
    </message>
    <message>
      <source>the sparse solver ran out of memory</source>
      <translation>dem dünnbesetzten Löser ging der Speicher aus</translation>
    </message>
    <message>
      <source>the sparse solver ran out of memory at {0} unknowns</source>
      <translation>dem dünnbesetzten Löser ging bei {0} Unbekannten der Speicher aus</translation>
    </message>
    <message>
      <source>the support of piece {0} falls apart</source>
      <translation>der Stützkörper von Stück {0} zerfällt</translation>
    </message>
    <message>
      <source>the support of piece {0} runs into piece {1}</source>
      <translation>der Stützkörper von Stück {0} läuft in Stück {1}</translation>
    </message>
    <message>
      <source>the surface can't be moved by that much</source>
      <translation>die Fläche lässt sich nicht so weit bewegen</translation>
    </message>
    <message>
      <source>the surface has no faces</source>
      <translation>Die Fläche hat keine Dreiecke</translation>
    </message>
    <message>
      <source>the surface has several components</source>
      <translation>die Fläche hat mehrere Teile</translation>
    </message>
    <message>
      <source>the surface has {0}{1} and no flat layout</source>
      <translation>die Fläche hat {0}{1} und keine Abwicklung</translation>
    </message>
    <message>
      <source>the surface has {count} components, which are laid out side by side</source>
      <translation>Die Fläche hat {count} Teile, die neben einander ausgelegt werden</translation>
    </message>
    <message>
      <source>the surface is closed and has no flat layout</source>
      <translation>die Fläche ist geschlossen und hat keine Abwicklung</translation>
    </message>
    <message>
      <source>the surface is closed: it can't lie flat in one piece</source>
      <translation>Die Fläche ist geschlossen: sie kann nicht in einem Stück flach liegen</translation>
    </message>
    <message>
      <source>the surface is not a manifold at face {0}</source>
      <translation>die Fläche ist bei Dreieck {0} nicht mannigfaltig</translation>
    </message>
    <message>
      <source>the surface is {size:.4g mm} large, smaller than one tile of L = {L:.4g mm}</source>
      <translation>Die Fläche ist {size:.4g mm} groß, kleiner als eine Kachel von L = {L:.4g mm}</translation>
    </message>
    <message>
      <source>the surface needs about {tiles_needed:.4g} tiles of L = {L:.4g mm}</source>
      <translation>Die Fläche braucht etwa {tiles_needed:.4g} Kacheln von L = {L:.4g mm}</translation>
    </message>
    <message>
      <source>the surface would need about {0} tiles of L = {1} mm</source>
      <translation>die Fläche bräuchte etwa {0} Kacheln mit L = {1} mm</translation>
    </message>
    <message>
      <source>the surplus membrane pulls with {pull:.3g N} at an anchor, whose glue then carries {shear:.3g MPa} of shear, more than glue_strength ({limit:g MPa}): raise anchor_radius</source>
      <translation>Die überstehende Membran zieht mit {pull:.3g N} an einem Anker, dessen Kleber dann {shear:.3g MPa} Schub trägt, mehr als glue_strength ({limit:g MPa}): anchor_radius erhöhen</translation>
    </message>
    <message>
      <source>the target is in {count} pieces, {asked} are asked for</source>
      <translation>Die Zielfläche besteht aus {count} Stücken, {asked} sind verlangt</translation>
    </message>
    <message>
      <source>the target is no file</source>
      <translation>die Zielfläche ist keine Datei</translation>
    </message>
    <message>
      <source>the target is tiled anew: {why}</source>
      <translation>das Ziel wird neu gekachelt: {why}</translation>
    </message>
    <message>
      <source>the target was deleted: choose another with Target</source>
      <translation>das Ziel wurde gelöscht: mit „Ziel ändern“ ein anderes wählen</translation>
    </message>
    <message>
      <source>the target's source {name} changed since the layout was solved: Solve brings it up to date</source>
      <translation>die Vorlage {name} des Ziels hat sich seit der Abwicklung geändert: „Lösen“ bringt es auf den neuesten Stand</translation>
    </message>
    <message>
      <source>the tiles are too thin for breakaway bridges</source>
      <translation>die Kacheln sind zu dünn für Brücken zum Wegbrechen</translation>
    </message>
    <message>
      <source>the tiles are up to {distance:.2g mm} from the surface</source>
      <translation>Die Kacheln sind bis zu {distance:.2g mm} von der Fläche entfernt</translation>
    </message>
    <message>
      <source>the tiles could not be smoothed</source>
      <translation>die Kacheln konnten nicht geglättet werden</translation>
    </message>
    <message>
      <source>the tiles follow the target: {kept} kept, {new} new</source>
      <translation>die Kacheln folgen dem Ziel: {kept} behalten, {new} neu</translation>
    </message>
    <message>
      <source>the tiles touch along their front edge only</source>
      <translation>die Kacheln berühren sich nur an der vorderen Kante</translation>
    </message>
    <message>
      <source>the tiles' balance could not be solved</source>
      <translation>das Gleichgewicht der Kacheln konnte nicht gelöst werden</translation>
    </message>
    <message>
      <source>the {0} membrane between {1} folds over itself in the layout</source>
      <translation>die Membran ({0}) zwischen {1} faltet sich in der Abwicklung über sich selbst</translation>
    </message>
    <message>
      <source>the {0} membrane found no equilibrium</source>
      <translation>die Membran ({0}) fand kein Gleichgewicht</translation>
    </message>
    <message>
      <source>the {0} pins of {1} have no area</source>
      <translation>die Zapfen ({0}) von {1} haben keinen Flächeninhalt</translation>
    </message>
    <message>
      <source>the {side} membrane is slack beside {beside:8}</source>
      <translation>Die Membran ({side}) ist schlaff neben {beside:8}</translation>
    </message>
    <message>
      <source>the {side} membrane nearly touches the body of {tile} (clearance {clearance:.3g mm})</source>
      <translation>Die Membran ({side}) berührt fast den Körper von {tile} (Abstand {clearance:.3g mm})</translation>
    </message>
    <message>
      <source>the {side} membrane would cut {depth:.3g mm} into the body of {tile}: raise H_pin or lower insets there</source>
      <translation>Die Membran ({side}) schnitte {depth:.3g mm} in den Körper von {tile}: H_pin erhöhen oder die Zapfen dort weniger zurücksetzen</translation>
    </message>
    <message>
      <source>the {side} pin of {tile} has {area_mm2:.3g mm2}: valid, but less than A_pin_min asks for</source>
      <translation>Der Zapfen ({side}) von {tile} hat {area_mm2:.3g mm2}: gültig, aber weniger, als A_pin_min verlangt</translation>
    </message>
    <message>
      <source>there are no bodies of the kind '{0}'</source>
      <translation>es gibt keine Körper der Art „{0}“</translation>
    </message>
    <message>
      <source>there are no tiles to cut between yet</source>
      <translation>es gibt noch keine Kacheln, zwischen denen man schneiden könnte</translation>
    </message>
    <message>
      <source>there are not as many targets as points</source>
      <translation>es gibt nicht so viele Ziele wie Punkte</translation>
    </message>
    <message>
      <source>there is no built-in target "{0}"</source>
      <translation>es gibt keine eingebaute Zielfläche „{0}“</translation>
    </message>
    <message>
      <source>there is no language '{0}'</source>
      <translation>es gibt keine Sprache „{0}“</translation>
    </message>
    <message>
      <source>there is no layout yet</source>
      <translation>es gibt noch keine Abwicklung</translation>
    </message>
    <message>
      <source>there is no layout yet: Solve makes it</source>
      <translation>es gibt noch keine Abwicklung: „Lösen“ berechnet sie</translation>
    </message>
    <message>
      <source>there is no membrane model '{0}'</source>
      <translation>es gibt kein Membranmodell „{0}“</translation>
    </message>
    <message>
      <source>there is no target</source>
      <translation>es gibt keine Zielfläche</translation>
    </message>
    <message>
      <source>there is no {0}</source>
      <translation>es gibt kein {0}</translation>
    </message>
    <message>
      <source>there is no {0} '{1}'</source>
      <translation>es gibt kein {0} „{1}“</translation>
    </message>
    <message>
      <source>there is no {0} skin: nothing of the part is a wall with two sides</source>
      <translation>es gibt keine Haut {0}: nichts am Teil ist eine Wand mit zwei Seiten</translation>
    </message>
    <message>
      <source>there is no {0} to start from</source>
      <translation>es gibt kein {0}, von dem auszugehen wäre</translation>
    </message>
    <message>
      <source>there is not enough memory</source>
      <translation>der Speicher reicht nicht</translation>
    </message>
    <message>
      <source>these limits are estimates: Solve tells whether a design is valid</source>
      <translation>Diese Grenzen sind geschätzt: Lösen sagt, ob ein Entwurf gültig ist</translation>
    </message>
    <message>
      <source>thin it out</source>
      <translation>ihn ausdünnen</translation>
    </message>
    <message>
      <source>this has no surface</source>
      <translation>das hat keine Oberfläche</translation>
    </message>
    <message>
      <source>this is a binary OFF file</source>
      <translation>das ist eine binäre OFF-Datei</translation>
    </message>
    <message>
      <source>this is no JSON: {0}</source>
      <translation>das ist kein JSON: {0}</translation>
    </message>
    <message>
      <source>this is no OFF file</source>
      <translation>das ist keine OFF-Datei</translation>
    </message>
    <message>
      <source>this is no STL file, or it ends early</source>
      <translation>das ist keine STL-Datei, oder sie endet zu früh</translation>
    </message>
    <message>
      <source>this is no readable 3MF file: {0}</source>
      <translation>das ist keine lesbare 3MF-Datei: {0}</translation>
    </message>
    <message>
      <source>this is no readable PLY file, or it ends early: {0}</source>
      <translation>das ist keine lesbare PLY-Datei, oder sie endet zu früh: {0}</translation>
    </message>
    <message>
      <source>this needs the Python package {0}, which this FreeCAD lacks</source>
      <translation>das braucht das Python-Paket {0}, das diesem FreeCAD fehlt</translation>
    </message>
    <message>
      <source>through the weak contact {contact}</source>
      <translation>durch den schwachen Kontakt {contact}</translation>
    </message>
    <message>
      <source>tiles and a soluble slab are of two materials, which can't be one shell</source>
      <translation>Kacheln und eine lösliche Platte sind aus zwei Materialien, die keine gemeinsame Hülle haben können</translation>
    </message>
    <message>
      <source>tiles are up to {distance:.2f mm} from the target, more than mend_max ({most:g mm}): they can't follow its corners and edges</source>
      <translation>Kacheln sind bis zu {distance:.2f mm} vom Ziel entfernt, mehr als mend_max ({most:g mm}): Sie können seinen Ecken und Kanten nicht folgen</translation>
    </message>
    <message>
      <source>tiles come as near as {clearance:.3g mm}; a {printer} needs {least:g mm}</source>
      <translation>Kacheln kommen sich bis auf {clearance:.3g mm} nah; ein {printer} braucht {least:g mm}</translation>
    </message>
    <message>
      <source>tiles have {0} to {1} mm: set scale for another unit, or remesh</source>
      <translation>Kacheln haben {0} bis {1} mm: für eine andere Einheit scale setzen, oder neu vernetzen</translation>
    </message>
    <message>
      <source>tiles of other parts that a tile runs into</source>
      <translation>Kacheln anderer Teile, in die eine Kachel läuft</translation>
    </message>
    <message>
      <source>tiles reach out level by up to {reach:.2g mm} beyond the pin they stand on, {H_pin:g mm} above the bed; a {printer} prints {most:g mm} without supports</source>
      <translation>Kacheln reichen waagrecht bis zu {reach:.2g mm} über den Zapfen hinaus, auf dem sie stehen, {H_pin:g mm} über dem Bett; ein {printer} druckt {most:g mm} ohne Stützen</translation>
    </message>
    <message>
      <source>tiles would be too large or too small for L</source>
      <translation>Kacheln wären zu groß oder zu klein für L</translation>
    </message>
    <message>
      <source>tiles would turn over</source>
      <translation>Kacheln würden umschlagen</translation>
    </message>
    <message>
      <source>to the tip at {tile}, which the flat map scales by {scale:.2g} of the mean</source>
      <translation>zur Spitze bei {tile}, die die flache Karte mit {scale:.2g} des Mittels skaliert</translation>
    </message>
    <message>
      <source>too many tiles would be new</source>
      <translation>zu viele Kacheln wären neu</translation>
    </message>
    <message>
      <source>too small for three bumps</source>
      <translation>zu klein für drei Noppen</translation>
    </message>
    <message>
      <source>tried {sizes:, }: not valid, {why:; }</source>
      <translation>Versucht {sizes:, }: nicht gültig, {why:; }</translation>
    </message>
    <message>
      <source>tried {sizes:, }: valid</source>
      <translation>Versucht {sizes:, }: gültig</translation>
    </message>
    <message>
      <source>trying {0}</source>
      <translation>{0} versuchen</translation>
    </message>
    <message>
      <source>two files would be called {0}</source>
      <translation>zwei Dateien hießen {0}</translation>
    </message>
    <message>
      <source>two sides of a cut need the same place in the flat layout, where the sheet would lie on itself between {contacts:8}</source>
      <translation>zwei Seiten eines Schnitts brauchen im flachen Layout denselben Platz, wo die Folie zwischen {contacts:8} auf sich selbst läge</translation>
    </message>
    <message>
      <source>unexpected failure: {0}</source>
      <translation>unerwarteter Fehler: {0}</translation>
    </message>
    <message>
      <source>uniting bodies</source>
      <translation>Körper vereinigen</translation>
    </message>
    <message>
      <source>unknown format '{0}'</source>
      <translation>unbekanntes Format „{0}“</translation>
    </message>
    <message>
      <source>unknown parameter '{0}'</source>
      <translation>unbekannter Parameter „{0}“</translation>
    </message>
    <message>
      <source>use a FreeCAD with Python {0}, or run tools/setup in a checkout</source>
      <translation>ein FreeCAD mit Python {0} verwenden, oder tools/setup in einem Checkout ausführen</translation>
    </message>
    <message>
      <source>use a coarser mesh</source>
      <translation>ein gröberes Netz verwenden</translation>
    </message>
    <message>
      <source>use a coarser mesh or a machine with more memory</source>
      <translation>ein gröberes Netz oder einen Rechner mit mehr Speicher verwenden</translation>
    </message>
    <message>
      <source>use larger tiles (--set L=...) or a smaller target</source>
      <translation>größere Kacheln (--set L=...) oder eine kleinere Zielfläche nehmen</translation>
    </message>
    <message>
      <source>use letters, digits, '-', '_', {0}</source>
      <translation>Buchstaben, Ziffern, „-“, „_“ und {0} verwenden</translation>
    </message>
    <message>
      <source>use the tension-field model</source>
      <translation>das Modell tension-field verwenden</translation>
    </message>
    <message>
      <source>use {0}</source>
      <translation>{0} verwenden</translation>
    </message>
    <message>
      <source>verification was off</source>
      <translation>Das Prüfen war abgeschaltet</translation>
    </message>
    <message>
      <source>volume</source>
      <translation>Volumen</translation>
    </message>
    <message>
      <source>wall beside the joint hole</source>
      <translation>Wand neben dem Nähloch</translation>
    </message>
    <message>
      <source>walls stand back by {set:g mm} for what prints grow; a {printer} grows walls by {grows:g mm}: raise xy_compensation</source>
      <translation>Wände stehen um {set:g mm} zurück für das, was Drucke wachsen; ein {printer} lässt Wände um {grows:g mm} wachsen: xy_compensation erhöhen</translation>
    </message>
    <message>
      <source>whether pushing forces within friction {mu:.3g} balance the tiles could not be shown{more}</source>
      <translation>Ob drückende Kräfte mit der Reibung {mu:.3g} die Kacheln im Gleichgewicht halten, ließ sich nicht zeigen{more}</translation>
    </message>
    <message>
      <source>whether the margin is met is not known: the forces at its corners could not be found</source>
      <translation>Ob die Reserve erfüllt ist, ist nicht bekannt: Die Kräfte an ihren Ecken ließen sich nicht finden</translation>
    </message>
    <message>
      <source>whether the shape holds is not known: the tiles do not come to rest</source>
      <translation>Ob die Form hält, ist nicht bekannt: die Kacheln kommen nicht zur Ruhe</translation>
    </message>
    <message>
      <source>whether the shape holds is not known: {error}</source>
      <translation>Ob die Form hält, ist nicht bekannt: {error}</translation>
    </message>
    <message>
      <source>with a friction coefficient of {mu:.3g} no pushing forces balance the tiles: {pull:.3g N} of pull would be needed, first at {contacts:8}{more}</source>
      <translation>Mit dem Reibungskoeffizienten {mu:.3g} halten keine drückenden Kräfte die Kacheln im Gleichgewicht: {pull:.3g N} Zug wären nötig, zuerst an {contacts:8}{more}</translation>
    </message>
    <message>
      <source>with a friction coefficient of {mu:.3g} pushing forces are not known to reach f_min = {f_min:.3g N} where only bumps' tips touch</source>
      <translation>Mit dem Reibungskoeffizienten {mu:.3g} ist von drückenden Kräften nicht bekannt, dass sie f_min = {f_min:.3g N} erreichen, wo nur Noppenspitzen sich berühren</translation>
    </message>
    <message>
      <source>without friction, its energy is least {mean:.3g mm} from the target in the mean, {largest:.3g mm} at most; {open} of {count} contacts are open there</source>
      <translation>ohne Reibung ist seine Energie im Mittel {mean:.3g mm} vom Ziel am kleinsten, höchstens {largest:.3g mm}; {open} von {count} Kontakten sind dort offen</translation>
    </message>
    <message>
      <source>without friction, the tiles do not come to rest</source>
      <translation>ohne Reibung kommen die Kacheln nicht zur Ruhe</translation>
    </message>
    <message>
      <source>working</source>
      <translation>Arbeit läuft</translation>
    </message>
    <message>
      <source>writing {0}</source>
      <translation>{0} schreiben</translation>
    </message>
    <message>
      <source>{0} and {1} nearly meet: there is a gap of {2} mm</source>
      <translation>{0} und {1} berühren sich fast: dazwischen ist eine Lücke von {2} mm</translation>
    </message>
    <message>
      <source>{0} can't be {1}</source>
      <translation>{0} kann nicht {1} sein</translation>
    </message>
    <message>
      <source>{0} can't change on {1}</source>
      <translation>{0} kann sich auf {1} nicht ändern</translation>
    </message>
    <message>
      <source>{0} could not be written: {1}</source>
      <translation>{0} ließ sich nicht schreiben: {1}</translation>
    </message>
    <message>
      <source>{0} edges have more than two faces (non-manifold)</source>
      <translation>{0} Kanten haben mehr als zwei Dreiecke (nicht mannigfaltig)</translation>
    </message>
    <message>
      <source>{0} face lies in {1} = {2}</source>
      <translation>{0} Fläche liegt in {1} = {2}</translation>
    </message>
    <message>
      <source>{0} faces have no area</source>
      <translation>{0} Dreiecke haben keinen Flächeninhalt</translation>
    </message>
    <message>
      <source>{0} follows an expression</source>
      <translation>{0} folgt einem Ausdruck</translation>
    </message>
    <message>
      <source>{0} has {1} rows, there are {2} tiles</source>
      <translation>{0} hat {1} Zeilen, es gibt {2} Kacheln</translation>
    </message>
    <message>
      <source>{0} holds a number that is not finite</source>
      <translation>{0} enthält eine Zahl, die nicht endlich ist</translation>
    </message>
    <message>
      <source>{0} points can't be laid onto a surface</source>
      <translation>{0} Punkte lassen sich nicht auf eine Fläche legen</translation>
    </message>
    <message>
      <source>{0} tiles are too few for {1} pieces</source>
      <translation>{0} Kacheln sind zu wenig für {1} Stücke</translation>
    </message>
    <message>
      <source>{0}-{1} is no interior edge of the mesh</source>
      <translation>{0}-{1} ist keine innere Kante des Netzes</translation>
    </message>
    <message>
      <source>{0}; or {1}</source>
      <translation>{0}; oder {1}</translation>
    </message>
    <message>
      <source>{0}=auto makes other tiles</source>
      <translation>{0}=auto macht andere Kacheln</translation>
    </message>
    <message>
      <source>{closed} of {edges} edges between pieces have no room for stitching holes: {pairs}</source>
      <translation>{closed} von {edges} Kanten zwischen Stücken haben keinen Platz für Nählöcher: {pairs}</translation>
    </message>
    <message>
      <source>{count} anchors are not held by the support</source>
      <translation>{count} Anker hält der Stützkörper nicht</translation>
    </message>
    <message>
      <source>{count} bodies have features smaller than a {printer} makes; {body}: {place}, {size:.3g mm}</source>
      <translation>{count} Körper haben kleinere Stellen, als ein {printer} macht; {body}: {place}, {size:.3g mm}</translation>
    </message>
    <message>
      <source>{count} contacts are only a hinge: nothing but the front edge touches</source>
      <translation>{count} Kontakte sind nur ein Scharnier: nichts als die vordere Kante berührt sich</translation>
    </message>
    <message>
      <source>{count} contacts are only a hinge: truncation leaves no interface</source>
      <translation>{count} Kontakte sind nur ein Scharnier: die Kappung lässt keine Berührfläche</translation>
    </message>
    <message>
      <source>{count} edges of cuts are gone with their tiles</source>
      <translation>{count} Kanten von Schnitten sind mit ihren Kacheln weggefallen</translation>
    </message>
    <message>
      <source>{count} faces are there twice</source>
      <translation>{count} Dreiecke sind doppelt vorhanden</translation>
    </message>
    <message>
      <source>{count} faces are turned against their neighbours</source>
      <translation>{count} Dreiecke sind gegen ihre Nachbarn gewendet</translation>
    </message>
    <message>
      <source>{count} faces have no area</source>
      <translation>{count} Dreiecke haben keinen Flächeninhalt</translation>
    </message>
    <message>
      <source>{count} faces lie where front meets back: the surface has one side</source>
      <translation>{count} Dreiecke liegen dort, wo vorn auf hinten trifft: die Fläche hat nur eine Seite</translation>
    </message>
    <message>
      <source>{count} faces meet at edges of more than two faces</source>
      <translation>{count} Dreiecke treffen sich an Kanten von mehr als zwei Dreiecken</translation>
    </message>
    <message>
      <source>{count} faces name vertices that do not exist</source>
      <translation>{count} Dreiecke nennen Ecken, die es nicht gibt</translation>
    </message>
    <message>
      <source>{count} faces run through others of the same surface</source>
      <translation>{count} Dreiecke gehen durch andere derselben Fläche</translation>
    </message>
    <message>
      <source>{count} interfaces carry no bumps: {why}</source>
      <translation>{count} Berührflächen tragen keine Noppen: {why}</translation>
    </message>
    <message>
      <source>{count} of {of} tiles can't be made ({at:6})</source>
      <translation>{count} von {of} Kacheln lassen sich nicht machen ({at:6})</translation>
    </message>
    <message>
      <source>{count} of {of} tiles can't be made or are likely to fail</source>
      <translation>{count} von {of} Kacheln lassen sich nicht herstellen oder misslingen wahrscheinlich</translation>
    </message>
    <message>
      <source>{count} pairs of tiles overlap in the target and no plane separates them without losing a contact</source>
      <translation>{count} Paare von Kacheln überlappen in der Zielfläche, und keine Ebene trennt sie, ohne dass ein Kontakt verloren geht</translation>
    </message>
    <message>
      <source>{count} pairs of tiles overlap when actuated and no plane parts them ({pairs:6})</source>
      <translation>{count} Paare von Kacheln überlappen in Form, und keine Ebene trennt sie ({pairs:6})</translation>
    </message>
    <message>
      <source>{count} pairs of tiles without a common corner would overlap when actuated; interfaces were shortened to part them: {pairs:6}</source>
      <translation>{count} Paare von Kacheln ohne gemeinsame Ecke überlappten in Form; Berührflächen wurden gekürzt, um sie zu trennen: {pairs:6}</translation>
    </message>
    <message>
      <source>{count} pin sides are smaller than A_pin_floor ({at:6})</source>
      <translation>{count} Zapfenenden sind kleiner als A_pin_floor ({at:6})</translation>
    </message>
    <message>
      <source>{count} pin sides can't reach A_pin_min ({A_pin_min:.3g mm2}); the smallest has {least:.3g mm2}</source>
      <translation>{count} Zapfenenden erreichen A_pin_min nicht ({A_pin_min:.3g mm2}); das kleinste hat {least:.3g mm2}</translation>
    </message>
    <message>
      <source>{count} tiles are far smaller or larger than L ({L:.3g mm})</source>
      <translation>{count} Kacheln sind weit kleiner oder größer als L ({L:.3g mm})</translation>
    </message>
    <message>
      <source>{count} tiles are likely to fail ({at:6})</source>
      <translation>{count} Kacheln halten wohl nicht ({at:6})</translation>
    </message>
    <message>
      <source>{count} tiles are not held by the support</source>
      <translation>{count} Kacheln hält der Stützkörper nicht</translation>
    </message>
    <message>
      <source>{count} tiles lie at folds sharper than a tile of thickness {H_body:.3g mm} can have: their back faces vanish</source>
      <translation>{count} Kacheln liegen an Falten, die schärfer sind, als eine Kachel der Dicke {H_body:.3g mm} sie haben kann: ihre Rückseiten verschwinden</translation>
    </message>
    <message>
      <source>{count} vertices are not finite (vertices {vertices:#5})</source>
      <translation>{count} Ecken sind nicht endlich (Ecken {vertices:#5})</translation>
    </message>
    <message>
      <source>{names} changed since the design was judged: Verify brings it up to date</source>
      <translation>{names} hat sich geändert, seit der Entwurf beurteilt wurde: „Prüfen“ bringt es auf den neuesten Stand</translation>
    </message>
    <message>
      <source>{names} changed since the layout was solved: Solve brings it up to date</source>
      <translation>{names} hat sich seit der Abwicklung geändert: „Lösen“ bringt es auf den neuesten Stand</translation>
    </message>
    <message>
      <source>{names} changed since the path was computed: Actuate brings it up to date</source>
      <translation>{names} hat sich geändert, seit der Weg berechnet wurde: „Aufrichten“ bringt ihn auf den neuesten Stand</translation>
    </message>
    <message>
      <source>{names} changed since the target was divided: Solve brings it up to date</source>
      <translation>{names} hat sich geändert, seit das Ziel geteilt wurde: „Lösen“ bringt es auf den neuesten Stand</translation>
    </message>
    <message>
      <source>{names} changed since this was built: BuildSolids brings it up to date</source>
      <translation>{names} hat sich geändert, seit dies gebaut wurde: „Volumenkörper bauen“ bringt es auf den neuesten Stand</translation>
    </message>
    <message>
      <source>{other}, another part of the target, faces it so near that pins between them would meet</source>
      <translation>{other}, ein anderer Teil der Zielfläche, liegt ihr so nah gegenüber, dass Zapfen dazwischen sich träfen</translation>
    </message>
    <message>
      <source>{points} contact points push too weakly or pull ({pulling} pull): less than f_min = {f_min:.3g N} at {contacts:8}; the weakest has {least:.3g N} at {weakest}</source>
      <translation>{points} Kontaktpunkte drücken zu schwach oder ziehen ({pulling} ziehen): weniger als f_min = {f_min:.3g N} an {contacts:8}; der schwächste hat {least:.3g N} an {weakest}</translation>
    </message>
    <message>
      <source>{points} contact points push too weakly: less than f_min = {f_min:.3g N} at {contacts:8}; the weakest has {least:.3g N} at {weakest}</source>
      <translation>{points} Kontaktpunkte drücken zu schwach: weniger als f_min = {f_min:.3g N} an {contacts:8}; der schwächste hat {least:.3g N} an {weakest}</translation>
    </message>
  </context>
  <context>
    <name>CurveUps_Guide</name>
    <message>
      <source>Guide</source>
      <translation>Anleitung</translation>
    </message>
    <message>
      <source>Guide to CurveUps</source>
      <translation>Anleitung zu CurveUps</translation>
    </message>
    <message>
      <source>Open the guide, from a surface to print files</source>
      <translation>Die Anleitung öffnen, von einer Fläche zu Druckdateien</translation>
    </message>
  </context>
  <context>
    <name>CurveUps_Kit</name>
    <message>
      <source>Fabrication Kit</source>
      <translation>Bausatz</translation>
    </message>
    <message>
      <source>Write the order for the print shop, templates for the latex and the steps of assembly</source>
      <translation>Die Bestellung für die Druckerei, Schablonen für das Latex und die Schritte des Zusammenbaus schreiben</translation>
    </message>
    <message>
      <source>open the folder</source>
      <translation>Ordner öffnen</translation>
    </message>
    <message>
      <source>the back template</source>
      <translation>die Schablone der Rückseite</translation>
    </message>
    <message>
      <source>the front template</source>
      <translation>die Schablone der Vorderseite</translation>
    </message>
    <message>
      <source>the order for the print shop</source>
      <translation>die Bestellung für die Druckerei</translation>
    </message>
    <message>
      <source>the steps of assembly</source>
      <translation>die Schritte des Zusammenbaus</translation>
    </message>
  </context>
  <context>
    <name>CurveUps_LittleFriction</name>
    <message>
      <source>Let It Need Little Friction</source>
      <translation>Wenig Reibung brauchen lassen</translation>
    </message>
    <message>
      <source>Move pins and tiles of the layout until the design needs as little friction as it can, so that the piece comes to rest near its target</source>
      <translation>Stifte und Kacheln des Layouts bewegen, bis der Entwurf so wenig Reibung braucht wie möglich und das Teil nahe am Ziel zur Ruhe kommt</translation>
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
    <message>
      <source>select one</source>
      <translation>eine auswählen</translation>
    </message>
    <message>
      <source>{count} surfaces are selected</source>
      <translation>{count} Flächen sind ausgewählt</translation>
    </message>
  </context>
  <context>
    <name>CurveUps_Overlay</name>
    <message>
      <source>Choose a value to colour by first</source>
      <translation>Zuerst einen Wert zum Färben wählen</translation>
    </message>
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
      <source>Side by side shows both ends</source>
      <translation>„Nebeneinander“ zeigt beide Enden</translation>
    </message>
    <message>
      <source>not the present state: {why}</source>
      <translation>nicht der jetzige Stand: {why}</translation>
    </message>
    <message>
      <source>of the layout, L = {length}, Tau = {tau}</source>
      <translation>der Abwicklung, L = {length}, Tau = {tau}</translation>
    </message>
    <message>
      <source>of the target, L = {length}</source>
      <translation>des Ziels, L = {length}</translation>
    </message>
    <message>
      <source>of the verified layout, L = {length}, Tau = {tau}</source>
      <translation>der geprüften Abwicklung, L = {length}, Tau = {tau}</translation>
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
    <name>CurveUps_Sheets</name>
    <message>
      <source>As it was printed, the {side} is up.</source>
      <translation>So wie gedruckt wurde, liegt die {side} oben.</translation>
    </message>
    <message>
      <source>Bring pieces together in shape and sew them along their borders</source>
      <translation>Die Stücke in Form zusammenlegen und an ihren Rändern vernähen</translation>
    </message>
    <message>
      <source>Cut both sheets out of their rings together</source>
      <translation>Beide Folien gemeinsam aus den Ringen schneiden</translation>
    </message>
    <message>
      <source>Cut the front membrane along its lines, which were {trim:g} mm outside of the outer pins while it was stretched, and the back one as far outside of its own pins. {stop} Anchors go with the surplus. {apart}</source>
      <translation>Die vordere Membran entlang ihrer Linien schneiden, die {trim:g} mm außerhalb der äußeren Zapfen lagen, solange sie gedehnt war, und die hintere ebenso weit außerhalb ihrer eigenen Zapfen. {stop} Die Anker gehen mit dem Überstand weg. {apart}</translation>
    </message>
    <message>
      <source>Cut the surplus off</source>
      <translation>Den Überstand abschneiden</translation>
    </message>
    <message>
      <source>Do not order it as it is: the design is not valid.</source>
      <translation>Nicht so bestellen: der Entwurf ist nicht gültig.</translation>
    </message>
    <message>
      <source>Do not order it as it is: the design is not verified.</source>
      <translation>Nicht so bestellen: der Entwurf ist nicht geprüft.</translation>
    </message>
    <message>
      <source>Do not scale or arrange: bodies stand in their places, and {tiles} of them are meant to be apart.</source>
      <translation>Nicht skalieren oder anordnen: die Körper stehen an ihren Plätzen, und {tiles} davon sollen getrennt sein.</translation>
    </message>
    <message>
      <source>Do not scale, turn or arrange: bodies stand in their places, and {tiles} of them are meant to be apart.</source>
      <translation>Nicht skalieren, drehen oder anordnen: die Körper stehen an ihren Plätzen, und {tiles} davon sollen getrennt sein.</translation>
    </message>
    <message>
      <source>Each piece has its own former, from the left to the right.</source>
      <translation>Jedes Stück hat seinen eigenen Formkörper, von links nach rechts.</translation>
    </message>
    <message>
      <source>FDM printer, 0.4 mm nozzle</source>
      <translation>FDM-Drucker, Düse 0.4 mm</translation>
    </message>
    <message>
      <source>Files, in mm, with bytes and SHA-256:</source>
      <translation>Dateien, in mm, mit Bytes und SHA-256:</translation>
    </message>
    <message>
      <source>Finish</source>
      <translation>Oberfläche</translation>
    </message>
    <message>
      <source>Follow rims, holes and cuts. Where the drawing has small circles, punch these first: they keep a cut from tearing on.</source>
      <translation>Rändern, Löchern und Schnitten folgen. Wo die Zeichnung kleine Kreise hat, diese zuerst ausstanzen: sie verhindern, dass ein Schnitt weiterreißt.</translation>
    </message>
    <message>
      <source>For {paper} paper: print at 100 % (“actual size”), not fitted to the page; measure the ruler.</source>
      <translation>Für Papier {paper}: mit 100 % („tatsächliche Größe“) drucken, nicht an die Seite angepasst; das Lineal nachmessen.</translation>
    </message>
    <message>
      <source>Former</source>
      <translation>Formkörper</translation>
    </message>
    <message>
      <source>Frame</source>
      <translation>Rahmen</translation>
    </message>
    <message>
      <source>Glue</source>
      <translation>Kleber</translation>
    </message>
    <message>
      <source>Glue the {first} first</source>
      <translation>Zuerst die {first} kleben</translation>
    </message>
    <message>
      <source>Glue the {second} pins and the other end of the anchors</source>
      <translation>Die Zapfen der {second} und das andere Ende der Anker kleben</translation>
    </message>
    <message>
      <source>Join the pieces</source>
      <translation>Die Stücke verbinden</translation>
    </message>
    <message>
      <source>Latex</source>
      <translation>Latex</translation>
    </message>
    <message>
      <source>Latex {thickness:g} mm thick. Wash it, dry it, pull it to some {tau:g} times its size and let it go, twice. Then trace the lines with a pen whose ink stays on latex, cut it {x:.0f} × {y:.0f} mm along the outer line ({grip:g} mm around are for the hands), and punch a hole of {hole:g} mm in every circle.</source>
      <translation>Latex, {thickness:g} mm dick. Waschen, trocknen, auf etwa das {tau:g}-Fache ziehen und loslassen, zweimal. Dann die Linien mit einem Stift nachziehen, dessen Farbe auf Latex haftet, auf {x:.0f} × {y:.0f} mm entlang der äußeren Linie schneiden ({grip:g} mm ringsum sind für die Hände) und in jeden Kreis ein Loch von {hole:g} mm stanzen.</translation>
    </message>
    <message>
      <source>Lay the parts side by side</source>
      <translation>Die Teile nebeneinanderlegen</translation>
    </message>
    <message>
      <source>Lay the print down with its {first} up</source>
      <translation>Den Druck mit seiner {first} nach oben hinlegen</translation>
    </message>
    <message>
      <source>Lay the {parts} parts, their {first} up, into the frame {name}-frame.dxf, cut of a plate 3 mm thick, by their numbers ({which}), and press them together. A part fits its pocket with its {first} up alone. Parts that lie askew leave gaps wider than {opening:g} mm: file their edges. The first membrane is glued over all of them at once.</source>
      <translation>Die {parts} Teile, ihre {first} oben, nach ihren Nummern ({which}) in den Rahmen {name}-frame.dxf legen, der aus einer 3 mm dicken Platte geschnitten ist, und zusammenschieben. Ein Teil passt nur mit seiner {first} oben in seine Tasche. Teile, die schief liegen, lassen mehr als {opening:g} mm Spalt: ihre Kanten feilen. Die erste Membran wird auf einmal über alle geklebt.</translation>
    </message>
    <message>
      <source>Layer, tolerance</source>
      <translation>Schicht, Toleranz</translation>
    </message>
    <message>
      <source>Least clearance between tiles</source>
      <translation>Kleinster Abstand zwischen Kacheln</translation>
    </message>
    <message>
      <source>Leave all where it lies, and lower the stretched {first} sheet onto it, with its teeth down and the print in the middle of the window.</source>
      <translation>Alles liegen lassen und die gedehnte Folie der {first} daraufsenken, mit den Zähnen nach unten und dem Druck in der Mitte des Fensters.</translation>
    </message>
    <message>
      <source>Leave the bridges between the tiles in: do not break them. They alone keep the tiles in place.</source>
      <translation>Die Brücken zwischen den Kacheln nicht herausbrechen: nur sie halten die Kacheln an ihrem Platz.</translation>
    </message>
    <message>
      <source>Leave the support in: do not wash it off. It alone keeps the tiles in place. Name the bath that dissolves it.</source>
      <translation>Das Stützmaterial nicht auswaschen: nur es hält die Kacheln an ihrem Platz. Das Bad nennen, das es löst.</translation>
    </message>
    <message>
      <source>Let the slicer put supports below tiles that reach out, on the bed alone, and leave these in, too: whoever puts the print together takes them off.</source>
      <translation>Den Slicer unter Kacheln, die überstehen, Stützen setzen lassen, nur auf dem Druckbett, und auch diese darin lassen: wer den Druck zusammenbaut, nimmt sie ab.</translation>
    </message>
    <message>
      <source>Look at the print</source>
      <translation>Den Druck ansehen</translation>
    </message>
    <message>
      <source>Map of tiles</source>
      <translation>Plan der Kacheln</translation>
    </message>
    <message>
      <source>Material</source>
      <translation>Material</translation>
    </message>
    <message>
      <source>Nothing joins the tiles: keep each in its place, on the bed's plate or on adhesive film.</source>
      <translation>Nichts verbindet die Kacheln: jede an ihrem Platz lassen, auf der Bettplatte oder auf Klebefolie.</translation>
    </message>
    <message>
      <source>Numbers of tiles from the front, and mirrored from the back: 12 is T00012. Red: tiles of the weakest contacts. {name}-tiles.svg has it large enough to read.</source>
      <translation>Nummern der Kacheln von vorne und gespiegelt von hinten: 12 ist T00012. Rot: Kacheln der schwächsten Kontakte. {name}-tiles.svg hat den Plan groß genug zum Lesen.</translation>
    </message>
    <message>
      <source>On the {on_bed} {level}. Bridges alone hold the tiles meanwhile, and break easily.</source>
      <translation>Auf der {on_bed} {level}. Nur die Brücken halten inzwischen die Kacheln, und sie brechen leicht.</translation>
    </message>
    <message>
      <source>On the {second} {level} and would be glued along.</source>
      <translation>Auf der {second} {level} und würden mitgeklebt.</translation>
    </message>
    <message>
      <source>Once the glue holds, {away}. {stays}: it alone keeps the tiles in their places now.</source>
      <translation>Sobald der Kleber hält, {away}. {stays}: nur sie hält jetzt die Kacheln an ihrem Platz.</translation>
    </message>
    <message>
      <source>One build: all bodies belong together, {pieces} pieces of them.</source>
      <translation>Ein Druck: alle Körper gehören zusammen, in {pieces} Stücken.</translation>
    </message>
    <message>
      <source>One build: all bodies belong together.</source>
      <translation>Ein Druck: alle Körper gehören zusammen.</translation>
    </message>
    <message>
      <source>One page follows.</source>
      <translation>Eine Seite folgt.</translation>
    </message>
    <message>
      <source>Orientation</source>
      <translation>Ausrichtung</translation>
    </message>
    <message>
      <source>PLA or PETG</source>
      <translation>PLA oder PETG</translation>
    </message>
    <message>
      <source>Parts of the print with their numbers, seen from above, the side that lies up on the beds.</source>
      <translation>Teile des Drucks mit ihren Nummern, von oben gesehen, die Seite oben, die auf den Betten oben liegt.</translation>
    </message>
    <message>
      <source>Peel the slicer's supports off the {on_bed}, tile by tile</source>
      <translation>Die Stützen des Slicers Kachel für Kachel von der {on_bed} lösen</translation>
    </message>
    <message>
      <source>Print</source>
      <translation>Druck</translation>
    </message>
    <message>
      <source>Print the drawing {name}-frame.pdf at 100 %, and hold the {parts} parts on it by thin double-sided tape below them, their {first} up, tile on tile, by their numbers ({which}). A part matches the drawing with its {first} up alone. Gaps between parts are {opening:g} mm wider than those inside of them, and no tile may be more than {error:g} mm off its place. The first membrane is glued over all of them at once.</source>
      <translation>Die Zeichnung {name}-frame.pdf mit 100 % drucken und die {parts} Teile mit dünnem doppelseitigem Klebeband unter ihnen darauf befestigen, ihre {first} oben, Kachel auf Kachel, nach ihren Nummern ({which}). Ein Teil stimmt nur mit seiner {first} oben mit der Zeichnung überein. Spalte zwischen Teilen sind {opening:g} mm breiter als die in ihnen, und keine Kachel darf mehr als {error:g} mm neben ihrem Platz liegen. Die erste Membran wird auf einmal über alle geklebt.</translation>
    </message>
    <message>
      <source>Printer compared with</source>
      <translation>Verglichen mit dem Drucker</translation>
    </message>
    <message>
      <source>Quantity</source>
      <translation>Anzahl</translation>
    </message>
    <message>
      <source>Rigid material</source>
      <translation>Hartes Material</translation>
    </message>
    <message>
      <source>Roll {second_cm3:.2f} cm³ of glue onto the pins and anchors of the {second} ({second_mm2:.0f} mm²), as before. Lay the second membrane on, stretched on its ring, with its teeth down: the rings close face to face, {height:g} mm apart, and the teeth of one stand in the middle between those of the other. Rods in the holes at the corners align them: punch the rims of the sheets there, where nothing pulls. Press through both windows, as long as before.</source>
      <translation>{second_cm3:.2f} cm³ Kleber wie zuvor auf Zapfen und Anker der {second} ({second_mm2:.0f} mm²) rollen. Die zweite Membran auflegen, gedehnt auf ihrem Ring, mit den Zähnen nach unten: die Ringe schließen sich Fläche an Fläche, {height:g} mm voneinander, und die Zähne des einen stehen mitten zwischen denen des anderen. Stäbe in den Löchern an den Ecken richten sie aus: dort die Ränder der Folien lochen, an denen nichts zieht. Durch beide Fenster pressen, so lange wie zuvor.</translation>
    </message>
    <message>
      <source>Seen from the front, at the size of the stretched sheet. Lay it on the front sheet before that leaves its ring: the thin triangles are the outer pins, what stands around them are anchors. Copy the thick red lines, {trim:g} mm outside of the pins, and cut along these once the shell is off its rings. Where small circles lie on them, punch these first.</source>
      <translation>Von vorne gesehen, in der Größe der gedehnten Folie. Auf die Folie der Vorderseite legen, bevor sie vom Ring kommt: die dünnen Dreiecke sind die äußeren Zapfen, was um sie herum steht, sind Anker. Die dicken roten Linien, {trim:g} mm außerhalb der Zapfen, übertragen und daran entlang schneiden, sobald die Schale von den Ringen ist. Wo kleine Kreise auf ihnen liegen, diese zuerst ausstanzen.</translation>
    </message>
    <message>
      <source>Ship flat, between two stiff boards.</source>
      <translation>Flach versenden, zwischen zwei steifen Platten.</translation>
    </message>
    <message>
      <source>Size</source>
      <translation>Größe</translation>
    </message>
    <message>
      <source>Smallest feature</source>
      <translation>Kleinstes Detail</translation>
    </message>
    <message>
      <source>So the {pieces} pieces come apart: each holds its shape by itself.</source>
      <translation>So trennen sich die {pieces} Stücke: jedes hält seine Form allein.</translation>
    </message>
    <message>
      <source>Stretch both membranes to {tau:g} times their length, each over the teeth of its own ring: every hole comes onto a tooth, {pitch:g} mm from the next. The sheet lies on the face that the teeth stick out of, with its lines on the ring, since glue does not hold on ink. Begin in the middles of opposite sides, and end at the corners. The window inside measures {window[0]:.0f} × {window[1]:.0f} mm. The back ring's teeth, and so its sheet, lie {half:g} mm off its middle along both sides: that is meant, they pass between those of the front. Measure through the window: each of the five control squares of {square:g} mm must read {stretched:g} ± {slack:.1f} mm in both directions. Where one does not, a hole hangs on the wrong tooth or has torn out: hang its rows anew. Stretch both within an hour, and glue both on the same day: latex that stays stretched loses some quarter of its pull in a day, most of it in the first hours. Measure once more just before gluing, since latex creeps. The front sheet pulls with {front[0]:.0f} N at the left and right sides of its ring and {front[1]:.0f} N at the others, the back sheet with {back[0]:.0f} N and {back[1]:.0f} N: wear goggles, a sheet that slips off snaps back.</source>
      <translation>Beide Membranen auf das {tau:g}-Fache ihrer Länge dehnen, jede über die Zähne ihres eigenen Rings: jedes Loch kommt auf einen Zahn, {pitch:g} mm vom nächsten. Die Folie liegt auf der Fläche, aus der die Zähne ragen, mit den Linien zum Ring, denn auf Farbe hält kein Kleber. In der Mitte gegenüberliegender Seiten beginnen und an den Ecken enden. Das Fenster innen misst {window[0]:.0f} × {window[1]:.0f} mm. Die Zähne des hinteren Rings und damit seine Folie liegen an beiden Seiten {half:g} mm neben seiner Mitte: das ist so gewollt, sie gehen zwischen denen des vorderen hindurch. Durch das Fenster messen: jedes der fünf Prüfquadrate von {square:g} mm muss in beiden Richtungen {stretched:g} ± {slack:.1f} mm messen. Wo eines das nicht tut, hängt ein Loch am falschen Zahn oder ist ausgerissen: seine Reihen neu aufhängen. Beide innerhalb einer Stunde dehnen und am selben Tag kleben: Latex, das gedehnt bleibt, verliert an einem Tag etwa ein Viertel seines Zugs, das meiste davon in den ersten Stunden. Kurz vor dem Kleben noch einmal messen, denn Latex kriecht. Die vordere Folie zieht mit {front[0]:.0f} N an der linken und rechten Seite ihres Rings und mit {front[1]:.0f} N an den anderen, die hintere mit {back[0]:.0f} N und {back[1]:.0f} N: Schutzbrille tragen, eine Folie, die abrutscht, schnellt zurück.</translation>
    </message>
    <message>
      <source>Stretch both sheets</source>
      <translation>Beide Folien dehnen</translation>
    </message>
    <message>
      <source>Stretch it to {tau:g} times its length in both directions, until each hole is on a tooth of the ring, {pitch:g} mm from the next. The five squares of {square:g} mm must then read {stretched:g} mm in both directions. Latex creeps: measure them once more just before gluing.</source>
      <translation>Auf das {tau:g}-Fache ihrer Länge in beiden Richtungen dehnen, bis jedes Loch auf einem Zahn des Rings sitzt, {pitch:g} mm vom nächsten. Die fünf Quadrate von {square:g} mm müssen dann in beiden Richtungen {stretched:g} mm messen. Latex kriecht: kurz vor dem Kleben noch einmal messen.</translation>
    </message>
    <message>
      <source>Stretching rings</source>
      <translation>Spannringe</translation>
    </message>
    <message>
      <source>Support material</source>
      <translation>Stützmaterial</translation>
    </message>
    <message>
      <source>Take care with the tiles of the weakest contacts: {worst}.</source>
      <translation>Vorsicht mit den Kacheln der schwächsten Kontakte: {worst}.</translation>
    </message>
    <message>
      <source>Take the bath that the shop names for its support, if scraps of the latex and the glue have stood it, and a tub that holds the ring. The membrane stays on its ring while it is washed and dries</source>
      <translation>Das Bad nehmen, das der Druckdienst für sein Stützmaterial nennt, wenn Reste von Latex und Kleber es vertragen haben, und eine Wanne, in die der Ring passt. Die Membran bleibt auf ihrem Ring, während sie gewaschen wird und trocknet</translation>
    </message>
    <message>
      <source>Take {latex}. Wash powder and grease off with lukewarm water and a drop of dish soap, rinse the sheets and let them dry. Pull each by hand to some {tau:g} times its size and let it go, twice: latex softens the first time. Then copy the template of each onto it: lay thin latex on the paper and trace what shows through, or use carbon paper. Draw the grid, the circles, the control squares and the cutting line with a pen whose ink stays on latex, and write FRONT or BACK on the rim. Cut along the outer line. Punch a hole of {punch:g} mm in every circle, with a sharp punch: latex tears on from a nick. Wear gloves. Keep the sheets away from oil, from sun and from whoever is allergic to latex.</source>
      <translation>Benötigt: {latex}. Puder und Fett mit lauwarmem Wasser und einem Tropfen Spülmittel abwaschen, die Folien abspülen und trocknen lassen. Jede von Hand zweimal auf etwa das {tau:g}-Fache ihrer Größe ziehen und loslassen: beim ersten Mal wird Latex weicher. Dann die Schablone jeder Folie übertragen: dünnes Latex auf das Papier legen und nachziehen, was durchscheint, oder Kohlepapier nehmen. Raster, Kreise, Prüfquadrate und Schnittlinie mit einem Stift zeichnen, dessen Farbe auf Latex haftet, und FRONT oder BACK auf den Rand schreiben. Entlang der äußeren Linie schneiden. In jeden Kreis mit einem scharfen Locheisen ein Loch von {punch:g} mm stanzen: an einer Kerbe reißt Latex weiter. Handschuhe tragen. Die Folien von Öl, von der Sonne und von allen fernhalten, die gegen Latex allergisch sind.</translation>
    </message>
    <message>
      <source>Templates</source>
      <translation>Schablonen</translation>
    </message>
    <message>
      <source>The membrane stays on its ring</source>
      <translation>Die Membran bleibt auf ihrem Ring</translation>
    </message>
    <message>
      <source>The pages that follow list the files.</source>
      <translation>Die folgenden Seiten nennen die Dateien.</translation>
    </message>
    <message>
      <source>The parts lie with their {first} up</source>
      <translation>Die Teile liegen mit ihrer {first} nach oben</translation>
    </message>
    <message>
      <source>The sheet pulls with {load[0]:.0f} N at the left and right sides and {load[1]:.0f} N at the others. The print comes into the middle of the window; some millimetres beside it do no harm.</source>
      <translation>Die Folie zieht mit {load[0]:.0f} N an der linken und rechten Seite und mit {load[1]:.0f} N an den anderen. Der Druck kommt in die Mitte des Fensters; einige Millimeter daneben schaden nicht.</translation>
    </message>
    <message>
      <source>These tiles lie side by side then, each in a piece of its own: {pairs}.</source>
      <translation>Diese Kacheln liegen dann Seite an Seite, jede in einem eigenen Stück: {pairs}.</translation>
    </message>
    <message>
      <source>They come in {front} and {back} parts for the bed: split them in the slicer, and glue them at their dovetails on a flat table.</source>
      <translation>Für das Bett bestehen sie aus {front} und {back} Teilen: im Slicer trennen und auf einem ebenen Tisch an ihren Schwalbenschwänzen verkleben.</translation>
    </message>
    <message>
      <source>Tilt the whole of it by 30° to 45°, so that no layer is peeled off the vat by its whole area, on supports of the slicer's, which touch the side on the bed alone. Wash, take these supports off, and cure with the bridges on.</source>
      <translation>Das Ganze um 30° bis 45° neigen, damit keine Schicht mit ihrer ganzen Fläche von der Wanne abgezogen wird, auf Stützen des Slicers, die nur die Seite am Bett berühren. Waschen, diese Stützen abnehmen und mit den Brücken aushärten.</translation>
    </message>
    <message>
      <source>To be printed</source>
      <translation>Zu drucken</translation>
    </message>
    <message>
      <source>Tools</source>
      <translation>Werkzeug</translation>
    </message>
    <message>
      <source>Turn all bodies together by a right angle: so they fit the bed. Do not scale or arrange them, and do not turn single ones: they stand in their places, and {tiles} of them are meant to be apart.</source>
      <translation>Alle Körper gemeinsam um einen rechten Winkel drehen: so passen sie auf das Druckbett. Sie weder skalieren noch anordnen noch einzeln drehen: sie stehen an ihren Plätzen, und {tiles} davon sollen getrennt sein.</translation>
    </message>
    <message>
      <source>Turn each of the {pieces} pieces over by itself and lay it, glue down, onto the stretched {first} sheet, all of them around the middle of the window and as far apart as they were printed.</source>
      <translation>Jedes der {pieces} Stücke für sich wenden und mit dem Kleber nach unten auf die gedehnte Folie der {first} legen, alle um die Mitte des Fensters herum und so weit voneinander, wie sie gedruckt wurden.</translation>
    </message>
    <message>
      <source>Turn the print over and lay it, glue down, onto the stretched {first} sheet, in the middle of the window.</source>
      <translation>Den Druck wenden und mit dem Kleber nach unten in der Mitte des Fensters auf die gedehnte Folie der {first} legen.</translation>
    </message>
    <message>
      <source>Uncover the {second}</source>
      <translation>Die {second} freilegen</translation>
    </message>
    <message>
      <source>Wash and mark the latex</source>
      <translation>Das Latex waschen und anzeichnen</translation>
    </message>
    <message>
      <source>When the glue holds, turn all over, so that the front sheet is up. Print {name}-trim.pdf at 100 %, cut the paper to the size of the window, lay it on the front sheet with its triangles on the outer pins, which you feel through it, and copy its lines onto the sheet. {each} Then cut both sheets at once with strong scissors along the inside of the window, outside of the anchors, a few centimetres at each side in turn: so they let go together. The shell pulls itself into shape. Help with your hands where it stays flat, from the middle outwards. Lay it with its back onto the kit's former: where it does not touch, it is not in shape yet. {own}</source>
      <translation>Wenn der Kleber hält, alles wenden, sodass die vordere Folie oben liegt. {name}-trim.pdf mit 100 % drucken, das Papier auf die Größe des Fensters schneiden, mit den Dreiecken auf den äußeren Zapfen, die man hindurch fühlt, auf die vordere Folie legen und die Linien auf die Folie übertragen. {each} Dann beide Folien mit einer starken Schere auf einmal innen am Fenster entlang schneiden, außerhalb der Anker, reihum an jeder Seite einige Zentimeter: so geben sie gemeinsam nach. Die Schale zieht sich selbst in Form. Wo sie flach bleibt, von der Mitte nach außen mit den Händen nachhelfen. Sie mit der Rückseite auf den Formkörper legen: wo sie nicht anliegt, ist sie noch nicht in Form. {own}</translation>
    </message>
    <message>
      <source>Where bodies must not overlap, there is the same as one closed shell a piece, with fused in the name.</source>
      <translation>Wo Körper einander nicht überschneiden dürfen, gibt es dasselbe als eine geschlossene Schale je Stück, mit fused im Namen.</translation>
    </message>
    <message>
      <source>Where the pieces did not come to lie as far apart as they were printed, cut the paper between them, and lay each part of it on its own piece.</source>
      <translation>Liegen die Stücke nicht so weit voneinander, wie sie gedruckt wurden, das Papier zwischen ihnen durchschneiden und jeden Teil auf sein eigenes Stück legen.</translation>
    </message>
    <message>
      <source>a plate 3 mm thick, cut by {name}-frame.dxf, for the {count} parts of the print</source>
      <translation>eine 3 mm dicke Platte, nach {name}-frame.dxf geschnitten, für die {count} Teile des Drucks</translation>
    </message>
    <message>
      <source>anchors</source>
      <translation>Anker</translation>
    </message>
    <message>
      <source>and that holds {shear:.2f} MPa in shear (of the program's materials: {does})</source>
      <translation>und der auf Scherung {shear:.2f} MPa hält (von den Materialien des Programms: {does})</translation>
    </message>
    <message>
      <source>as printed, not smoothed</source>
      <translation>wie gedruckt, nicht geglättet</translation>
    </message>
    <message>
      <source>back</source>
      <translation>Rückseite</translation>
    </message>
    <message>
      <source>back, mirrored</source>
      <translation>Rückseite, gespiegelt</translation>
    </message>
    <message>
      <source>bed {number}: {x:.1f} × {y:.1f} × {z:.1f} mm</source>
      <translation>Bett {number}: {x:.1f} × {y:.1f} × {z:.1f} mm</translation>
    </message>
    <message>
      <source>box of the print</source>
      <translation>Umriss des Drucks</translation>
    </message>
    <message>
      <source>bridges: {count}</source>
      <translation>Brücken: {count}</translation>
    </message>
    <message>
      <source>desktop resin printer (LCD, 10 inch class)</source>
      <translation>Tisch-Resindrucker (LCD, 10-Zoll-Klasse)</translation>
    </message>
    <message>
      <source>dissolve the slab and let the tiles dry</source>
      <translation>die Platte auflösen und die Kacheln trocknen lassen</translation>
    </message>
    <message>
      <source>en</source>
      <translation>de</translation>
    </message>
    <message>
      <source>from bed {bed}: {parts}</source>
      <translation>von Bett {bed}: {parts}</translation>
    </message>
    <message>
      <source>front</source>
      <translation>Vorderseite</translation>
    </message>
    <message>
      <source>front side down</source>
      <translation>Vorderseite unten</translation>
    </message>
    <message>
      <source>front side up</source>
      <translation>Vorderseite oben</translation>
    </message>
    <message>
      <source>glossy; a matte coat leaves a film of support on the pins, to which glue does not hold</source>
      <translation>glänzend; ein matter Überzug lässt einen Film von Stützmaterial auf den Zapfen, auf dem Kleber nicht hält</translation>
    </message>
    <message>
      <source>in {pieces} separate pieces</source>
      <translation>in {pieces} getrennten Stücken</translation>
    </message>
    <message>
      <source>none</source>
      <translation>keiner</translation>
    </message>
    <message>
      <source>on a bed of {x:g} × {y:g} mm</source>
      <translation>auf einem Bett von {x:g} × {y:g} mm</translation>
    </message>
    <message>
      <source>on the shape, from two sides</source>
      <translation>auf der Form, von zwei Seiten</translation>
    </message>
    <message>
      <source>on the stretched sheet</source>
      <translation>auf der gedehnten Folie</translation>
    </message>
    <message>
      <source>one material: {material}</source>
      <translation>ein Material: {material}</translation>
    </message>
    <message>
      <source>peel the slicer's supports off the {on_bed}</source>
      <translation>die Stützen des Slicers von der {on_bed} lösen</translation>
    </message>
    <message>
      <source>polyjet printer (Stratasys J750)</source>
      <translation>Polyjet-Drucker (Stratasys J750)</translation>
    </message>
    <message>
      <source>print</source>
      <translation>Druck</translation>
    </message>
    <message>
      <source>rigid photopolymer (Vero, RGD or alike)</source>
      <translation>hartes Photopolymer (Vero, RGD oder ähnlich)</translation>
    </message>
    <message>
      <source>slab</source>
      <translation>Platte</translation>
    </message>
    <message>
      <source>slabs: {count}</source>
      <translation>Platten: {count}</translation>
    </message>
    <message>
      <source>standard or tough resin, nothing flexible</source>
      <translation>Standard- oder zähes Harz, nichts Biegsames</translation>
    </message>
    <message>
      <source>strong scissors, a sharp punch of {punch:g} mm, a pen whose ink stays on latex, carbon paper, tape, dish soap, a roller, a ruler, two boards thicker than a ring ({thickness:g} mm), larger than the print and smaller than the window, weights, gloves, goggles</source>
      <translation>starke Schere, ein scharfes Locheisen von {punch:g} mm, ein Stift, dessen Farbe auf Latex haftet, Kohlepapier, Klebeband, Spülmittel, eine Rolle, ein Lineal, zwei Bretter, dicker als ein Ring ({thickness:g} mm), größer als der Druck und kleiner als das Fenster, Gewichte, Handschuhe, Schutzbrille</translation>
    </message>
    <message>
      <source>take the drawing and its tape off</source>
      <translation>die Zeichnung mit ihrem Klebeband abnehmen</translation>
    </message>
    <message>
      <source>the print does not fit</source>
      <translation>der Druck passt nicht</translation>
    </message>
    <message>
      <source>the print fits</source>
      <translation>der Druck passt</translation>
    </message>
    <message>
      <source>the print fits as {name} turns and moves it</source>
      <translation>der Druck passt so, wie {name} ihn dreht und verschiebt</translation>
    </message>
    <message>
      <source>the print fits without {anchors} of its anchors</source>
      <translation>der Druck passt ohne {anchors} seiner Anker</translation>
    </message>
    <message>
      <source>the print fits, turned by a right angle</source>
      <translation>der Druck passt, um einen rechten Winkel gedreht</translation>
    </message>
    <message>
      <source>the print is divided among {beds} beds</source>
      <translation>der Druck ist auf {beds} Betten verteilt</translation>
    </message>
    <message>
      <source>the slab lies level with the pins ({area:.0f} mm²)</source>
      <translation>liegen die Flächen der Platte ({area:.0f} mm²) auf Höhe der Zapfen</translation>
    </message>
    <message>
      <source>the slicer's supports lie level with the pins</source>
      <translation>liegen die Stützen des Slicers auf Höhe der Zapfen</translation>
    </message>
    <message>
      <source>tiles</source>
      <translation>Kacheln</translation>
    </message>
    <message>
      <source>turn the ring over, so that you can reach the {second}</source>
      <translation>den Ring wenden, sodass die {second} zugänglich ist</translation>
    </message>
    <message>
      <source>two frames of {outer:.0f} × {high:.0f} × {thickness:g} mm around a window of {width:.0f} × {height:.0f} mm. Print {name}-ring-front.step and {name}-ring-back.step, or their STL, of rigid plastic, lying flat with the teeth up. {joined} Or saw them of plywood of that thickness ({name}-ring-front.dxf and {name}-ring-back.dxf) and glue {teeth} dowels of {dowel:g} × {length:g} mm into each as teeth, of which {tooth:g} mm stick out, their ends rounded and sanded. 4 rods of {dowel:g} × {rod:g} mm in the holes at the corners align the rings</source>
      <translation>zwei Rahmen von {outer:.0f} × {high:.0f} × {thickness:g} mm um ein Fenster von {width:.0f} × {height:.0f} mm. {name}-ring-front.step und {name}-ring-back.step oder ihre STL aus hartem Kunststoff drucken, flach liegend, mit den Zähnen nach oben. {joined} Oder aus Sperrholz dieser Dicke sägen ({name}-ring-front.dxf und {name}-ring-back.dxf) und in jeden {teeth} Dübel von {dowel:g} × {length:g} mm als Zähne einleimen, die {tooth:g} mm vorstehen, die Enden gerundet und geschliffen. 4 Stäbe von {dowel:g} × {rod:g} mm in den Löchern an den Ecken richten die Ringe aus</translation>
    </message>
    <message>
      <source>two materials: {material}, and support that a bath dissolves</source>
      <translation>zwei Materialien: {material}, und Stützmaterial, das sich in einem Bad löst</translation>
    </message>
    <message>
      <source>two sheets of latex, {thickness} mm thick, shear modulus {modulus} MPa, each at least {x:.0f} × {y:.0f} mm before it is stretched, of which {grip:g} mm around are for the grip</source>
      <translation>zwei Latexfolien, {thickness} mm dick, Schubmodul {modulus} MPa, jede ungedehnt mindestens {x:.0f} × {y:.0f} mm groß, davon ringsum {grip:g} mm zum Greifen</translation>
    </message>
    <message>
      <source>washed and cured, no coat and no varnish</source>
      <translation>gewaschen und ausgehärtet, kein Überzug und kein Lack</translation>
    </message>
    <message>
      <source>window of the ring</source>
      <translation>Fenster des Rings</translation>
    </message>
    <message>
      <source>{beds} builds, one a bed: the bodies of a bed belong together.</source>
      <translation>{beds} Druckaufträge, einer je Bett: die Körper eines Betts gehören zusammen.</translation>
    </message>
    <message>
      <source>{count} anchors</source>
      <translation>{count} Anker</translation>
    </message>
    <message>
      <source>{count} pages follow, which overlap by {overlap:g} mm: lay cross on cross. This page shows the whole, and which page has which part.</source>
      <translation>{count} Seiten folgen, die sich um {overlap:g} mm überlappen: Kreuz auf Kreuz legen. Diese Seite zeigt das Ganze, und welche Seite welchen Teil hat.</translation>
    </message>
    <message>
      <source>{count} tiles</source>
      <translation>{count} Kacheln</translation>
    </message>
    <message>
      <source>{down}: pins and anchors alone stand out there ({first_mm2:.0f} mm²). {behind} Roll {first_cm3:.2f} cm³ of glue onto the tops of these, {layer:g} mm thick, with a roller that touches nothing below: a glue for rubber on hard plastic that water does not loosen. Walls, gaps and all that holds the tiles together stay dry. {lay} Press sheet and print together between two boards that fit through the window, with weights spread evenly, for as long as the glue's maker says. Air the room: the glue's vapour harms you.</source>
      <translation>{down}: dort stehen nur Zapfen und Anker vor ({first_mm2:.0f} mm²). {behind} {first_cm3:.2f} cm³ Kleber auf die Enden dieser Zapfen und Anker rollen, {layer:g} mm dick, mit einer Rolle, die darunter nichts berührt: einen Kleber für Gummi auf hartem Kunststoff, den Wasser nicht löst. Wände, Spalte und alles, was die Kacheln zusammenhält, bleiben trocken. {lay} Folie und Druck zwischen zwei Brettern, die durch das Fenster passen, mit gleichmäßig verteilten Gewichten so lange zusammenpressen, wie es der Hersteller des Klebers sagt. Lüften: die Dämpfe des Klebers sind schädlich.</translation>
    </message>
    <message>
      <source>{each}; the picture has the others</source>
      <translation>{each}; die anderen nennt das Bild</translation>
    </message>
    <message>
      <source>{facing} Nothing joins them: tape or glue them along their borders.</source>
      <translation>{facing} Nichts verbindet sie: an ihren Rändern mit Klebeband oder Kleber verbinden.</translation>
    </message>
    <message>
      <source>{facing} Sew with a strong thread through the membrane into a stitching hole ({hole:g} mm), out at its other side, and back through the hole that faces it in the other piece; {holes} holes in all. A drop of glue around a hole keeps the membrane from tearing on. Pull the thread tight when all stitches are in.</source>
      <translation>{facing} Mit starkem Faden durch die Membran in ein Nähloch ({hole:g} mm) nähen, an der anderen Seite hinaus und durch das gegenüberliegende Loch des anderen Stücks zurück; insgesamt {holes} Löcher. Ein Tropfen Kleber um ein Loch verhindert, dass die Membran weiterreißt. Den Faden festziehen, wenn alle Stiche sitzen.</translation>
    </message>
    <message>
      <source>{feature:.3g} mm; the printer makes {least:g} mm</source>
      <translation>{feature:.3g} mm; der Drucker schafft {least:g} mm</translation>
    </message>
    <message>
      <source>{first} or .step: every body with its name, in place. The print as it is does not fit the bed</source>
      <translation>{first} oder .step: jeder Körper mit seinem Namen an seinem Platz. Der Druck, wie er ist, passt nicht auf das Bett</translation>
    </message>
    <message>
      <source>{first} to {last}, or .step: a job a bed, every body with its name, in place. The print as a whole does not fit the bed</source>
      <translation>{first} bis {last}, oder .step: ein Auftrag je Bett, jeder Körper mit seinem Namen an seinem Platz. Der Druck als Ganzes passt nicht auf das Bett</translation>
    </message>
    <message>
      <source>{front:.2f} cm³ for the front and {back:.2f} cm³ for the back, and half as much again for the roller; a glue for rubber on hard plastic, that water does not loosen{asked}; for rings in parts or with dowels also a rigid one</source>
      <translation>{front:.2f} cm³ für die Vorderseite und {back:.2f} cm³ für die Rückseite, und noch halb so viel für die Rolle; ein Kleber für Gummi auf hartem Kunststoff, den Wasser nicht löst{asked}; für Ringe in Teilen oder mit Dübeln auch ein fester</translation>
    </message>
    <message>
      <source>{front:g} (front) and {back:g} (back)</source>
      <translation>{front:g} (vorne) und {back:g} (hinten)</translation>
    </message>
    <message>
      <source>{gap} mm; the printer needs {least:g} mm</source>
      <translation>{gap} mm; der Drucker braucht {least:g} mm</translation>
    </message>
    <message>
      <source>{height:g} mm high</source>
      <translation>{height:g} mm hoch</translation>
    </message>
    <message>
      <source>{layer:g} mm or less, ± {tolerance:g} mm</source>
      <translation>{layer:g} mm oder weniger, ± {tolerance:g} mm</translation>
    </message>
    <message>
      <source>{lies} There are {bodies} bodies: {counts}. The map at the end of this sheet has the number of each tile. What is missing or broken is printed anew by its number, and laid into its place before gluing: the program CurveUps writes tile 12 by “curveups export design.json --tiles T00012 -o spares”. {weak}</source>
      <translation>{lies} Es sind {bodies} Körper: {counts}. Der Plan am Ende dieser Anleitung hat die Nummer jeder Kachel. Was fehlt oder zerbrochen ist, wird nach seiner Nummer neu gedruckt und vor dem Kleben an seinen Platz gelegt: das Programm CurveUps schreibt Kachel 12 mit „curveups export design.json --tiles T00012 -o spares“. {weak}</translation>
    </message>
    <message>
      <source>{name}-former.stl, {volume:.0f} cm³, printed hollow of any plastic</source>
      <translation>{name}-former.stl, {volume:.0f} cm³, hohl gedruckt aus beliebigem Kunststoff</translation>
    </message>
    <message>
      <source>{name}-latex-front.pdf and {name}-latex-back.pdf, printed at 100 %, the pages of one size of paper: A4, A3 or Letter</source>
      <translation>{name}-latex-front.pdf und {name}-latex-back.pdf, mit 100 % gedruckt, die Seiten eines Papierformats: A4, A3 oder Letter</translation>
    </message>
    <message>
      <source>{printer}: bed {bed} mm, {fits}</source>
      <translation>{printer}: Bett {bed} mm, {fits}</translation>
    </message>
    <message>
      <source>{quantity}, of {bodies} bodies each ({tiles} tiles) {pieces}</source>
      <translation>{quantity}, je {bodies} Körper ({tiles} Kacheln) {pieces}</translation>
    </message>
    <message>
      <source>{side} ring</source>
      <translation>Ring der {side}</translation>
    </message>
    <message>
      <source>{side} sheet, its lines on this side</source>
      <translation>Folie der {side}, Linien auf dieser Seite</translation>
    </message>
    <message>
      <source>{side}, as the files stand; support is printed with the parts</source>
      <translation>{side}, so wie die Dateien stehen; Stützen werden mit den Teilen gedruckt</translation>
    </message>
    <message>
      <source>{side}, tilted as a whole; the bridges are printed with the parts</source>
      <translation>{side}, als Ganzes geneigt; die Brücken werden mit den Teilen gedruckt</translation>
    </message>
    <message>
      <source>{some} and {last}</source>
      <translation>{some} und {last}</translation>
    </message>
    <message>
      <source>{threemf} or {step}: every body with its name, in place; or the files of tiles, anchors and support, with one origin</source>
      <translation>{threemf} oder {step}: jeder Körper mit Namen, an seinem Platz; oder die Dateien von Kacheln, Ankern und Stützen, mit einem Ursprung</translation>
    </message>
    <message>
      <source>{tiles} tiles and what holds them: {name}-shop.pdf is the order</source>
      <translation>{tiles} Kacheln und was sie hält: {name}-shop.pdf ist die Bestellung</translation>
    </message>
    <message>
      <source>{title}, frame</source>
      <translation>{title}, Rahmen</translation>
    </message>
    <message>
      <source>{title}, tiles</source>
      <translation>{title}, Kacheln</translation>
    </message>
    <message>
      <source>{title}, trim</source>
      <translation>{title}, Zuschnitt</translation>
    </message>
    <message>
      <source>{title}, {side} ring</source>
      <translation>{title}, Ring der {side}</translation>
    </message>
    <message>
      <source>{title}, {side} sheet</source>
      <translation>{title}, Folie der {side}</translation>
    </message>
    <message>
      <source>{title}: 12 is T00012</source>
      <translation>{title}: 12 ist T00012</translation>
    </message>
    <message>
      <source>{title}: assembly</source>
      <translation>{title}: Montage</translation>
    </message>
    <message>
      <source>{title}: cut {x:.0f} x {y:.0f} mm along the outer line, of which the outer {grip:g} mm are grip. Grid {grid:.4g} mm, stretched {pitch:g} mm; circles are holes for teeth. Squares {square:g} mm must read {stretched:g} mm when stretched, also just before gluing (creep).</source>
      <translation>{title}: auf {x:.0f} x {y:.0f} mm entlang der äußeren Linie schneiden, davon außen {grip:g} mm zum Greifen. Raster {grid:.4g} mm, gedehnt {pitch:g} mm; Kreise sind Löcher für Zähne. Quadrate von {square:g} mm müssen gedehnt {stretched:g} mm messen, auch kurz vor dem Kleben (Kriechen).</translation>
    </message>
    <message>
      <source>{title}: order for a 3D print</source>
      <translation>{title}: Bestellung eines 3D-Drucks</translation>
    </message>
    <message>
      <source>{title}: {paper}, page {number} of {count} (column {column}, row {row}). Print at 100 %: the ruler is {ruler:g} mm long.</source>
      <translation>{title}: {paper}, Seite {number} von {count} (Spalte {column}, Zeile {row}). Mit 100 % drucken: das Lineal ist {ruler:g} mm lang.</translation>
    </message>
    <message>
      <source>{title}: {thickness:g} mm plywood, holes {hole:g} mm</source>
      <translation>{title}: Sperrholz {thickness:g} mm, Löcher {hole:g} mm</translation>
    </message>
    <message>
      <source>{volume:.1f} cm³ (soluble)</source>
      <translation>{volume:.1f} cm³ (löslich)</translation>
    </message>
    <message>
      <source>{volume:.1f} cm³, {mass:.0f} g at {density:g} g/cm³ ({parts})</source>
      <translation>{volume:.1f} cm³, {mass:.0f} g bei {density:g} g/cm³ ({parts})</translation>
    </message>
    <message>
      <source>{volume}; the slicer's supports under tiles that reach out come on top</source>
      <translation>{volume}; dazu kommen die Stützen des Slicers unter Kacheln, die überstehen</translation>
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
      <source>Show Solids</source>
      <translation>Volumenkörper zeigen</translation>
    </message>
    <message>
      <source>Show tiles and anchors as printed solids. They are exact, but slow for thousands of tiles</source>
      <translation>Kacheln und Anker als gedruckte Volumenkörper zeigen. Sie sind genau, aber langsam bei Tausenden von Kacheln</translation>
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
      <source>none</source>
      <translation>keiner</translation>
    </message>
    <message>
      <source>ready; threads: {count}</source>
      <translation>bereit; Threads: {count}</translation>
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
    <name>CurveUps_TileAnew</name>
    <message>
      <source>Solve with new tiles: they do not follow the earlier ones, and get other numbers</source>
      <translation>Mit neuen Kacheln lösen: sie folgen den bisherigen nicht und bekommen andere Nummern</translation>
    </message>
    <message>
      <source>Tile Anew</source>
      <translation>Neu kacheln</translation>
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
      <source>, {count} with problems</source>
      <translation>, {count} mit Problemen</translation>
    </message>
    <message>
      <source>List contacts and tiles, the worst first. Click one to go there</source>
      <translation>Kontakte und Kacheln auflisten, die schlechtesten zuerst. Ein Klick führt hin</translation>
    </message>
    <message>
      <source>Worst Contacts</source>
      <translation>Schlechteste Kontakte</translation>
    </message>
    <message>
      <source>{shown} of {count} shown</source>
      <translation>{shown} von {count} gezeigt</translation>
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
    <name>KitPanel</name>
    <message>
      <source>Cancel</source>
      <translation>Abbrechen</translation>
    </message>
    <message>
      <source>End now. The folder then holds a part of the kit, and kit.json says so</source>
      <translation>Jetzt aufhören. Der Ordner enthält dann einen Teil des Bausatzes, und kit.json sagt das</translation>
    </message>
    <message>
      <source>Folder</source>
      <translation>Ordner</translation>
    </message>
    <message>
      <source>Kit</source>
      <translation>Bausatz</translation>
    </message>
    <message>
      <source>Name the print files: {name} stands for the design, {body} for what the file holds. Some shops ask for {material}, {thickness} and {quantity}</source>
      <translation>Die Druckdateien benennen: {name} steht für den Entwurf, {body} für den Inhalt der Datei. Manche Druckereien verlangen {material}, {thickness} und {quantity}</translation>
    </message>
    <message>
      <source>Names</source>
      <translation>Namen</translation>
    </message>
    <message>
      <source>Quantity</source>
      <translation>Anzahl</translation>
    </message>
    <message>
      <source>Set how many the print shop is to make</source>
      <translation>Festlegen, wie viele die Druckerei herstellen soll</translation>
    </message>
    <message>
      <source>The fabrication kit is out of date: the design has changed since</source>
      <translation>Der Bausatz ist veraltet: der Entwurf hat sich seitdem geändert</translation>
    </message>
    <message>
      <source>Verify the design and write all files into the folder</source>
      <translation>Den Entwurf prüfen und alle Dateien in den Ordner schreiben</translation>
    </message>
    <message>
      <source>Write the Kit</source>
      <translation>Schreiben</translation>
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
      <source>Give larger values the last colour</source>
      <translation>Größeren Werten die letzte Farbe geben</translation>
    </message>
    <message>
      <source>Give smaller values the first colour</source>
      <translation>Kleineren Werten die erste Farbe geben</translation>
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
      <source>Show all values except the lowest and highest hundredth</source>
      <translation>Alle Werte bis auf das niedrigste und das höchste Hundertstel zeigen</translation>
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
      <source>All parameters</source>
      <translation>Alle Parameter</translation>
    </message>
    <message>
      <source>Begin new designs with these parameters</source>
      <translation>Neue Entwürfe mit diesen Parametern beginnen</translation>
    </message>
    <message>
      <source>Cancel</source>
      <translation>Abbrechen</translation>
    </message>
    <message>
      <source>Check</source>
      <translation>Machbarkeit</translation>
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
      <source>Each alone</source>
      <translation>Jeweils allein</translation>
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
      <source>Find out which parts of the target can become tiles, before you solve</source>
      <translation>Vor dem Lösen herausfinden, welche Teile der Zielfläche Kacheln werden können</translation>
    </message>
    <message>
      <source>From</source>
      <translation>Von</translation>
    </message>
    <message>
      <source>Lay the tiles out flat, verify that the membranes hold the shape, and repair weak contacts</source>
      <translation>Die Kacheln flach auslegen, prüfen, ob die Membranen die Form halten, und schwache Kontakte reparieren</translation>
    </message>
    <message>
      <source>Materials</source>
      <translation>Materialien</translation>
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
      <source>Read how far each value alone may be off while shape and glue hold. ≤ and ≥ mean that nothing failed in the range that was searched. Click an end to select the tiles that fail first beyond it</source>
      <translation>Ablesen, wie weit jeder Wert für sich abweichen darf, während Form und Kleber halten. ≤ und ≥ heißen, dass im durchsuchten Bereich nichts versagte. Ein Klick auf ein Ende wählt die Kacheln aus, die jenseits davon zuerst versagen</translation>
    </message>
    <message>
      <source>Repair</source>
      <translation>Reparieren</translation>
    </message>
    <message>
      <source>Set the parameters of a membrane, a glue or a material of tiles (one step of undo)</source>
      <translation>Setzt die Parameter einer Membran, eines Klebers oder eines Materials der Kacheln (ein Schritt zum Rückgängigmachen)</translation>
    </message>
    <message>
      <source>Set the parameters that suit a kind of printer (one step of undo)</source>
      <translation>Die Parameter setzen, die zu einer Art von Drucker passen (ein Schritt beim Rückgängigmachen)</translation>
    </message>
    <message>
      <source>Show parameters that are seldom needed, too</source>
      <translation>Auch Parameter zeigen, die man selten braucht</translation>
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
      <source>To</source>
      <translation>Bis</translation>
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
      <source>Examples</source>
      <translation>Beispiele</translation>
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
  </context>
</TS>
