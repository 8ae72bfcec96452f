<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="de" sourcelanguage="en">
<context>
    <name>CoordinatesChoice</name>
    <message>
        <source>RAS</source>
        <translation>RAS</translation>
    </message>
    <message>
        <source>Y up</source>
        <translation>Y oben</translation>
    </message>
    <message>
        <source>LPS</source>
        <translation>LPS</translation>
    </message>
    <message>
        <source> and </source>
        <translation> und </translation>
    </message>
    <message>
        <source>%1 assumed</source>
        <translation>%1 angenommen</translation>
    </message>
    <message>
        <source>Coordinates: %1</source>
        <translation>Koordinaten: %1</translation>
    </message>
    <message>
        <source>File axes point left, posterior and superior, as in DICOM</source>
        <translation>Achsen der Dateien: links, hinten, kopfwärts, wie in DICOM</translation>
    </message>
    <message>
        <source>File axes point right, anterior and superior, as in older 3D Slicer models</source>
        <translation>Achsen der Dateien: rechts, vorn, kopfwärts, wie in älteren Modellen von 3D Slicer</translation>
    </message>
    <message>
        <source>File axes point left, superior and anterior, as in 3D modelling programs</source>
        <translation>Achsen der Dateien: links, kopfwärts, vorn, wie in 3D-Modellierprogrammen</translation>
    </message>
    <message>
        <source>The files use %1 coordinates.</source>
        <translation>Die Dateien verwenden %1-Koordinaten.</translation>
    </message>
    <message>
        <source>Some files do not state their axes. %1 is assumed; left and right may be swapped. Click to choose the axes.</source>
        <translation>Einige Dateien geben ihre Achsen nicht an. Angenommen wird %1; links und rechts können vertauscht sein. Klicken, um die Achsen zu wählen.</translation>
    </message>
    <message>
        <source>The surfaces belong to a recording and keep their recorded coordinates.</source>
        <translation>Die Oberflächen gehören zu einer Aufzeichnung und behalten deren Koordinaten.</translation>
    </message>
    <message>
        <source>Coordinates of the files</source>
        <translation>Koordinaten der Dateien</translation>
    </message>
    <message>
        <source>LPS: left, posterior, superior</source>
        <translation>LPS: links, hinten, oben</translation>
    </message>
    <message>
        <source>RAS: right, anterior, superior</source>
        <translation>RAS: rechts, vorn, oben</translation>
    </message>
    <message>
        <source>Y up: left, superior, anterior</source>
        <translation>Y nach oben: links, oben, vorn</translation>
    </message>
</context>
<context>
    <name>FeltLayers</name>
    <message>
        <source>%1 N</source>
        <translation>%1 N</translation>
    </message>
    <message>
        <source>holds %1 N</source>
        <translation>haftet %1 N</translation>
    </message>
    <message>
        <source>slides %1 N</source>
        <translation>gleitet %1 N</translation>
    </message>
    <message>
        <source>%1 N, pressed in %2 mm</source>
        <translation>%1 N, %2 mm eingedrückt</translation>
    </message>
</context>
<context>
    <name>FindingType</name>
    <message>
        <source>lump</source>
        <translation>Knoten</translation>
    </message>
    <message>
        <source>hard area</source>
        <translation>harte Stelle</translation>
    </message>
    <message>
        <source>soft area</source>
        <translation>weiche Stelle</translation>
    </message>
    <message>
        <source>landmark</source>
        <translation>Landmarke</translation>
    </message>
    <message>
        <source>keep away</source>
        <translation>zu meiden</translation>
    </message>
    <message>
        <source>other</source>
        <translation>anderes</translation>
    </message>
</context>
<context>
    <name>FindingsDesk</name>
    <message>
        <source>Finding %1</source>
        <translation>Befund %1</translation>
    </message>
    <message>
        <source>Note %1</source>
        <translation>Notiz %1</translation>
    </message>
    <message>
        <source>%1 was not marked in a recording.</source>
        <translation>%1 wurde nicht in einer Aufzeichnung markiert.</translation>
    </message>
    <message numerus="yes">
        <source>Import %n finding(s)</source>
        <translation>
            <numerusform>%n Befund importieren</numerusform>
            <numerusform>%n Befunde importieren</numerusform>
        </translation>
    </message>
    <message>
        <source>, stiffness %1</source>
        <translation>, Steifigkeit %1</translation>
    </message>
    <message>
        <source>Nothing is touched. Press on a place first, then mark a finding (M).</source>
        <translation>Nichts ist berührt. Erst auf eine Stelle drücken, dann einen Befund markieren (M).</translation>
    </message>
    <message>
        <source>%1 marked on %2 at %3 N</source>
        <translation>%1 auf %2 markiert, bei %3 N</translation>
    </message>
    <message>
        <source>No findings yet. Press on a place, then mark a finding (M).</source>
        <translation>Noch keine Befunde. Auf eine Stelle drücken, dann einen Befund markieren (M).</translation>
    </message>
    <message>
        <source>%1 has no saved view.</source>
        <translation>%1 hat keine gespeicherte Ansicht.</translation>
    </message>
    <message>
        <source>Recording in progress. Stop recording (R) before playing.</source>
        <translation>Aufzeichnung läuft. Vor dem Abspielen die Aufzeichnung beenden (R).</translation>
    </message>
    <message>
        <source>%1: the recording with %2 was not found.</source>
        <translation>%1: Die Aufzeichnung mit %2 wurde nicht gefunden.</translation>
    </message>
    <message>
        <source>%1: this is not the recording in which %2 was marked.</source>
        <translation>%1: Dies ist nicht die Aufzeichnung, in der %2 markiert wurde.</translation>
    </message>
    <message numerus="yes">
        <source>%n finding(s) exported to %1</source>
        <translation>
            <numerusform>%n Befund nach %1 exportiert</numerusform>
            <numerusform>%n Befunde nach %1 exportiert</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n finding(s) imported from %1</source>
        <translation>
            <numerusform>%n Befund aus %1 importiert</numerusform>
            <numerusform>%n Befunde aus %1 importiert</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>LumpLayout</name>
    <message>
        <source>%1: inside %2, felt as a layer below %2 (%3)</source>
        <translation>%1: in %2, tastbar als Schicht unter %2 (%3)</translation>
    </message>
    <message>
        <source>surface open or inside out</source>
        <translation>Oberfläche offen oder verkehrt herum</translation>
    </message>
    <message>
        <source>%1 is also a lump</source>
        <translation>%1 ist ebenfalls ein Knoten</translation>
    </message>
    <message>
        <source>the name %1 is not unique</source>
        <translation>der Name %1 ist nicht eindeutig</translation>
    </message>
    <message>
        <source>extends beyond %1</source>
        <translation>ragt aus %1 heraus</translation>
    </message>
    <message>
        <source>stiffness map on the lump or on %1</source>
        <translation>Steifigkeitskarte auf dem Knoten oder auf %1</translation>
    </message>
    <message>
        <source>stiffness ratio to %1 unknown: enter a ratio under What can be felt (B)</source>
        <translation>Steifigkeitsverhältnis zu %1 unbekannt: unter „Was tastbar ist“ (B) eingeben</translation>
    </message>
    <message>
        <source>same stiffness as %1</source>
        <translation>gleiche Steifigkeit wie %1</translation>
    </message>
    <message>
        <source>%1 lies in %2 and is felt through it, %3 times as stiff (%4)</source>
        <translation>%1 liegt in %2 und ist durch dieses Gewebe hindurch tastbar, %3-mal so steif (%4)</translation>
    </message>
</context>
<context>
    <name>MainWindow</name>
    <message>
        <source>Research, training and planning rehearsal. Not a medical device.</source>
        <translation>Forschung, Ausbildung und Planungsübung. Kein Medizinprodukt.</translation>
    </message>
    <message>
        <source>Quit</source>
        <translation>Beenden</translation>
    </message>
    <message>
        <source>&amp;File</source>
        <translation>&amp;Datei</translation>
    </message>
    <message>
        <source>Open recent</source>
        <translation>Zuletzt geöffnet</translation>
    </message>
    <message>
        <source>&amp;Edit</source>
        <translation>&amp;Bearbeiten</translation>
    </message>
    <message>
        <source>&amp;View</source>
        <translation>&amp;Ansicht</translation>
    </message>
    <message>
        <source>&amp;Session</source>
        <translation>&amp;Sitzung</translation>
    </message>
    <message>
        <source>&amp;Help</source>
        <translation>&amp;Hilfe</translation>
    </message>
    <message>
        <source>Tools</source>
        <translation>Werkzeuge</translation>
    </message>
    <message>
        <source>Appearance</source>
        <translation>Darstellung</translation>
    </message>
    <message>
        <source>Text size</source>
        <translation>Schriftgröße</translation>
    </message>
    <message>
        <source>Quit Palpate</source>
        <translation>Palpate beenden</translation>
    </message>
</context>
<context>
    <name>MeasuresDialog</name>
    <message>
        <source>Measuring…</source>
        <translation>Messe…</translation>
    </message>
    <message>
        <source>VTK poly data (*.vtp)</source>
        <translation>VTK-Polydaten (*.vtp)</translation>
    </message>
    <message>
        <source>Data table (CSV)</source>
        <translation>Datentabelle (CSV)</translation>
    </message>
    <message>
        <source>Data table (*.csv)</source>
        <translation>Datentabelle (*.csv)</translation>
    </message>
    <message>
        <source>Path and map for 3D Slicer</source>
        <translation>Weg und Karte für 3D Slicer</translation>
    </message>
    <message>
        <source>Results (JSON)</source>
        <translation>Ergebnisse (JSON)</translation>
    </message>
    <message>
        <source>Results (*.json)</source>
        <translation>Ergebnisse (*.json)</translation>
    </message>
    <message>
        <source>Results of %1</source>
        <translation>Ergebnisse von %1</translation>
    </message>
    <message>
        <source>Results of the session</source>
        <translation>Ergebnisse der Sitzung</translation>
    </message>
    <message>
        <source>Copy</source>
        <translation>Kopieren</translation>
    </message>
    <message>
        <source>Written to %1.</source>
        <translation>Nach %1 geschrieben.</translation>
    </message>
    <message>
        <source>Written to %1 and %2.</source>
        <translation>Nach %1 und %2 geschrieben.</translation>
    </message>
    <message>
        <source>Result of the last export</source>
        <translation>Ergebnis des letzten Exports</translation>
    </message>
    <message>
        <source>Export progress</source>
        <translation>Fortschritt des Exports</translation>
    </message>
    <message>
        <source>Cancel export</source>
        <translation>Export abbrechen</translation>
    </message>
    <message>
        <source>Copy all tables for a spreadsheet (Ctrl+C)</source>
        <translation>Alle Tabellen für eine Tabellenkalkulation kopieren (Strg+C)</translation>
    </message>
    <message>
        <source>Every sample with time, positions, forces, depth and events</source>
        <translation>Jeder Messpunkt mit Zeit, Positionen, Kräften, Tiefe und Ereignissen</translation>
    </message>
    <message>
        <source>Path of the hand, plus the touched surface with time spent and peak force</source>
        <translation>Weg der Hand, dazu die berührte Oberfläche mit Verweildauer und Spitzenkraft</translation>
    </message>
    <message>
        <source>All results in machine-readable form</source>
        <translation>Alle Ergebnisse in maschinenlesbarer Form</translation>
    </message>
    <message>
        <source>Copied. Paste into a spreadsheet.</source>
        <translation>Kopiert. In eine Tabellenkalkulation einfügen.</translation>
    </message>
    <message>
        <source>Nothing was written: %1 already exists. Enter the full file name to replace the file.</source>
        <translation>Nichts wurde geschrieben: %1 ist schon vorhanden. Zum Ersetzen den vollständigen Dateinamen eingeben.</translation>
    </message>
    <message>
        <source>Nothing was written: %1 ends in %2. For %3, enter a name that ends in %4.</source>
        <translation>Nichts wurde geschrieben: %1 endet auf %2. Für %3 einen Namen eingeben, der auf %4 endet.</translation>
    </message>
    <message>
        <source>The path was written to %1, but the surface was not: %2</source>
        <translation>Der Weg wurde nach %1 geschrieben, die Oberfläche nicht: %2</translation>
    </message>
</context>
<context>
    <name>OwnThreshold</name>
    <message>
        <source>%1 ± %2</source>
        <translation>%1 ± %2</translation>
    </message>
    <message>
        <source>for your hand: felt</source>
        <translation>für Ihre Hand: tastbar</translation>
    </message>
    <message>
        <source>for your hand: not felt</source>
        <translation>für Ihre Hand: nicht tastbar</translation>
    </message>
</context>
<context>
    <name>RecordingControl</name>
    <message>
        <source>Recording</source>
        <translation>Aufzeichnung</translation>
    </message>
    <message>
        <source>● recording %1, %2</source>
        <translation>● zeichnet %1 auf, %2</translation>
    </message>
    <message>
        <source>recording failed at %1</source>
        <translation>Aufzeichnung gescheitert bei %1</translation>
    </message>
    <message>
        <source>Length of the recording [min:s]. Late samples (1 ms each): the computer was too busy and nothing was felt. Lost samples: felt, but not recorded because the disk was too slow.</source>
        <translation>Länge der Aufzeichnung [min:s]. Verspätete Messpunkte (je 1 ms): Der Rechner war überlastet, nichts wurde gefühlt. Verlorene Messpunkte: gefühlt, aber nicht aufgezeichnet, weil der Datenträger zu langsam war.</translation>
    </message>
    <message>
        <source>Recording in progress. Stop recording and close?</source>
        <translation>Aufzeichnung läuft. Beenden und schließen?</translation>
    </message>
    <message>
        <source>The recording so far is kept in %1.</source>
        <translation>Die bisherige Aufzeichnung bleibt in %1.</translation>
    </message>
    <message>
        <source>Stop recording</source>
        <translation>Aufzeichnung beenden</translation>
    </message>
    <message>
        <source>Continue recording</source>
        <translation>Weiter aufzeichnen</translation>
    </message>
    <message>
        <source>● recording %1, disk not responding</source>
        <translation>● zeichnet %1 auf, Datenträger antwortet nicht</translation>
    </message>
    <message>
        <source>%1 stopped: write error</source>
        <translation>%1 gestoppt: Schreibfehler</translation>
    </message>
</context>
<context>
    <name>ResultTables</name>
    <message>
        <source>Session</source>
        <translation>Sitzung</translation>
    </message>
    <message>
        <source>Duration</source>
        <translation>Dauer</translation>
    </message>
    <message>
        <source>In contact</source>
        <translation>In Kontakt</translation>
    </message>
    <message>
        <source>Contacts</source>
        <translation>Kontakte</translation>
    </message>
    <message>
        <source>Path of the hand</source>
        <translation>Weg der Hand</translation>
    </message>
    <message>
        <source>Path on the surface</source>
        <translation>Weg auf der Oberfläche</translation>
    </message>
    <message>
        <source>%1 mm</source>
        <translation>%1 mm</translation>
    </message>
    <message>
        <source>Touch</source>
        <translation>Berührung</translation>
    </message>
    <message>
        <source>Force and depth</source>
        <translation>Kraft und Tiefe</translation>
    </message>
    <message>
        <source>Time spent [s]</source>
        <translation>Verweildauer [s]</translation>
    </message>
    <message>
        <source>Mean [N]</source>
        <translation>Mittel [N]</translation>
    </message>
    <message>
        <source>Median [N]</source>
        <translation>Median [N]</translation>
    </message>
    <message>
        <source>Peak [N]</source>
        <translation>Spitze [N]</translation>
    </message>
    <message>
        <source>Presses</source>
        <translation>Mal gedrückt</translation>
    </message>
    <message>
        <source>All</source>
        <translation>Gesamt</translation>
    </message>
    <message>
        <source>Hand</source>
        <translation>Hand</translation>
    </message>
    <message>
        <source>Phases</source>
        <translation>Phasen</translation>
    </message>
    <message>
        <source>Searching</source>
        <translation>Suchen</translation>
    </message>
    <message>
        <source>Pressing</source>
        <translation>Drücken</translation>
    </message>
    <message>
        <source>Surface</source>
        <translation>Oberfläche</translation>
    </message>
    <message>
        <source>Area [cm²]</source>
        <translation>Fläche [cm²]</translation>
    </message>
    <message>
        <source>Examined [%]</source>
        <translation>Untersucht [%]</translation>
    </message>
    <message>
        <source>Findings</source>
        <translation>Befunde</translation>
    </message>
    <message>
        <source>Finding</source>
        <translation>Befund</translation>
    </message>
    <message>
        <source>On</source>
        <translation>Auf</translation>
    </message>
    <message>
        <source>Marked</source>
        <translation>Markiert</translation>
    </message>
    <message>
        <source>First touched</source>
        <translation>Zuerst berührt</translation>
    </message>
    <message>
        <source>never</source>
        <translation>nie</translation>
    </message>
    <message>
        <source>Notes</source>
        <translation>Notizen</translation>
    </message>
    <message>
        <source>Note</source>
        <translation>Notiz</translation>
    </message>
    <message>
        <source>Written</source>
        <translation>Geschrieben</translation>
    </message>
    <message>
        <source>Structure</source>
        <translation>Struktur</translation>
    </message>
    <message>
        <source>Force [N]</source>
        <translation>Kraft [N]</translation>
    </message>
    <message>
        <source>Depth [mm]</source>
        <translation>Tiefe [mm]</translation>
    </message>
    <message>
        <source>Lump</source>
        <translation>Knoten</translation>
    </message>
    <message>
        <source>not by hand</source>
        <translation>nicht mit der Hand</translation>
    </message>
    <message>
        <source>Predicted by the model [%]</source>
        <translation>Vom Modell vorhergesagt [%]</translation>
    </message>
    <message>
        <source>Late samples</source>
        <translation>Verspätete Messpunkte</translation>
    </message>
    <message>
        <source>Lost samples</source>
        <translation>Verlorene Messpunkte</translation>
    </message>
    <message>
        <source>not stated</source>
        <translation>keine Angabe</translation>
    </message>
    <message>
        <source>95th percentile [N]</source>
        <translation>95. Perzentil [N]</translation>
    </message>
    <message>
        <source>Maximum depth [mm]</source>
        <translation>Größte Tiefe [mm]</translation>
    </message>
    <message>
        <source>Searching and pressing</source>
        <translation>Suchen und Drücken</translation>
    </message>
    <message>
        <source>Examined share of the surface (within %1, the fingertip radius)</source>
        <translation>Untersuchter Anteil der Oberfläche (innerhalb von %1, dem Radius der Fingerspitze)</translation>
    </message>
    <message>
        <source>Examined share of the surface (within %1)</source>
        <translation>Untersuchter Anteil der Oberfläche (innerhalb von %1)</translation>
    </message>
    <message>
        <source>Longest time at one point [s]</source>
        <translation>Längste Zeit an einem Punkt [s]</translation>
    </message>
    <message>
        <source>mesh not found</source>
        <translation>Netz nicht gefunden</translation>
    </message>
    <message>
        <source>Revisits</source>
        <translation>Erneute Besuche</translation>
    </message>
    <message>
        <source>Lumps: recorded response and model prediction (estimate)</source>
        <translation>Knoten: aufgezeichnete Reaktion und Vorhersage des Modells (Schätzung)</translation>
    </message>
    <message>
        <source>Organ</source>
        <translation>Organ</translation>
    </message>
    <message>
        <source>Palpable by a trained hand [cm²]</source>
        <translation>Für geübte Hand tastbar [cm²]</translation>
    </message>
    <message>
        <source>Pressed hard enough [%]</source>
        <translation>Fest genug gedrückt [%]</translation>
    </message>
    <message>
        <source>Largest recorded change [%]</source>
        <translation>Größte aufgezeichnete Änderung [%]</translation>
    </message>
    <message>
        <source>Findings by layer</source>
        <translation>Befunde nach Schichten</translation>
    </message>
    <message>
        <source>95th percentile: the force stayed below this value for 95 % of the contact time. Research measures, not a diagnosis.</source>
        <translation>95. Perzentil: Während 95 % der Kontaktzeit blieb die Kraft unter diesem Wert. Maße für die Forschung, keine Diagnose.</translation>
    </message>
    <message>
        <source>%1 % of the surface of %2</source>
        <translation>%1 % der Oberfläche von %2</translation>
    </message>
    <message>
        <source>The hand was in contact for %1, with a peak force of %2 N.</source>
        <translation>Die Hand hatte %1 Kontakt, mit einer größten Kraft von %2 N.</translation>
    </message>
    <message>
        <source>Examined: %1, with a peak force of %2 N.</source>
        <translation>Untersucht: %1, mit einer größten Kraft von %2 N.</translation>
    </message>
    <message numerus="yes">
        <source>%n finding(s) were marked.</source>
        <translation>
            <numerusform>%n Befund wurde markiert.</numerusform>
            <numerusform>%n Befunde wurden markiert.</numerusform>
        </translation>
    </message>
    <message>
        <source>Of %1 lumps, %2 are palpable by a trained hand; %3 of these were pressed hard enough to feel.</source>
        <translation>Von %1 Knoten sind %2 für eine geübte Hand tastbar; %3 davon wurden fest genug gedrückt.</translation>
    </message>
    <message>
        <source>%1 s</source>
        <translation>%1 s</translation>
    </message>
    <message>
        <source>%1 min</source>
        <translation>%1 min</translation>
    </message>
</context>
<context>
    <name>SceneDocument</name>
    <message>
        <source>Mark %1</source>
        <translation>%1 markieren</translation>
    </message>
    <message>
        <source>Unsaved changes would be lost in a crash. Save the scene. %1</source>
        <translation>Ungesicherte Änderungen gingen bei einem Absturz verloren. Sichern Sie die Szene. %1</translation>
    </message>
    <message>
        <source>Remove the image</source>
        <translation>Bild entfernen</translation>
    </message>
    <message>
        <source>Show %1</source>
        <translation>%1 zeigen</translation>
    </message>
    <message>
        <source>Move the section</source>
        <translation>Schnitt verschieben</translation>
    </message>
    <message>
        <source>Show a section</source>
        <translation>Schnitt zeigen</translation>
    </message>
    <message>
        <source>End the section</source>
        <translation>Schnitt beenden</translation>
    </message>
    <message>
        <source>Change the window of the image</source>
        <translation>Fenster des Bildes ändern</translation>
    </message>
</context>
<context>
    <name>palpate::Message</name>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>%1; %2</source>
        <translation>%1; %2</translation>
    </message>
    <message>
        <source>(%1 mm, %2 N)</source>
        <translation>(%1 mm, %2 N)</translation>
    </message>
    <message>
        <source>found %1, expected finite numbers</source>
        <translation>gefunden: %1, erwartet: endliche Zahlen</translation>
    </message>
    <message>
        <source>found %1, expected the first point at 0 mm and 0 N</source>
        <translation>gefunden: %1, erwartet: der erste Punkt bei 0 mm und 0 N</translation>
    </message>
    <message>
        <source>found %1, expected a force of at least 0 N</source>
        <translation>gefunden: %1, erwartet: eine Kraft von mindestens 0 N</translation>
    </message>
    <message>
        <source>found %1, expected a depth of %2 to %3 mm</source>
        <translation>gefunden: %1, erwartet: eine Tiefe von %2 bis %3 mm</translation>
    </message>
    <message>
        <source>found %1, a slope of %2 N/mm from the previous point, expected at most %3 N/mm</source>
        <translation>gefunden: %1, eine Steigung von %2 N/mm ab dem vorigen Punkt, erwartet: höchstens %3 N/mm</translation>
    </message>
    <message>
        <source>found more points, expected 2 to %1</source>
        <translation>mehr Punkte gefunden, erwartet: 2 bis %1</translation>
    </message>
    <message>
        <source>found %1 points, expected 2 to %2</source>
        <translation>%1 Punkte gefunden, erwartet: 2 bis %2</translation>
    </message>
    <message>
        <source>point %1 of %2: %3</source>
        <translation>Punkt %1 von %2: %3</translation>
    </message>
    <message>
        <source>%1: found %2, expected %3 to %4 %5</source>
        <translation>%1: gefunden: %2, erwartet: %3 bis %4 %5</translation>
    </message>
    <message>
        <source>%1: found %2, expected at most %3 (%4)</source>
        <translation>%1: gefunden: %2, erwartet: höchstens %3 (%4)</translation>
    </message>
    <message>
        <source>the force falls by %1 N/mm, expected at most %2 N/mm</source>
        <translation>die Kraft fällt um %1 N/mm, erwartet: höchstens %2 N/mm</translation>
    </message>
    <message>
        <source>No such file or directory</source>
        <translation>die Datei oder der Ordner ist nicht da</translation>
    </message>
    <message>
        <source>Permission denied</source>
        <translation>keine Berechtigung</translation>
    </message>
    <message>
        <source>Read-only file system</source>
        <translation>der Datenträger ist schreibgeschützt</translation>
    </message>
    <message>
        <source>No space left on device</source>
        <translation>der Datenträger ist voll</translation>
    </message>
    <message>
        <source>Disk quota exceeded</source>
        <translation>Speicherkontingent überschritten</translation>
    </message>
    <message>
        <source>File too large</source>
        <translation>Datei zu groß</translation>
    </message>
    <message>
        <source>Is a directory</source>
        <translation>ist ein Ordner</translation>
    </message>
    <message>
        <source>Not a directory</source>
        <translation>Kein Ordner</translation>
    </message>
    <message>
        <source>File exists</source>
        <translation>Datei existiert bereits</translation>
    </message>
    <message>
        <source>Input/output error</source>
        <translation>Ein-/Ausgabefehler</translation>
    </message>
    <message>
        <source>File name too long</source>
        <translation>Dateiname zu lang</translation>
    </message>
    <message>
        <source>Too many open files</source>
        <translation>Zu viele offene Dateien</translation>
    </message>
    <message>
        <source>not a file</source>
        <translation>keine Datei</translation>
    </message>
    <message>
        <source>%1: cannot be written: %2; choose another folder</source>
        <translation>%1: kann nicht geschrieben werden: %2; wählen Sie einen anderen Ordner</translation>
    </message>
    <message>
        <source>hand script: found no target, expected at least one</source>
        <translation>Handskript: kein Ziel gefunden, erwartet: mindestens eines</translation>
    </message>
    <message>
        <source>hand script: target %1 is not finite</source>
        <translation>Handskript: Ziel %1 ist nicht endlich</translation>
    </message>
    <message>
        <source>hand script: found target %1 at %2 s, expected a time after %3 s</source>
        <translation>Handskript: Ziel %1 bei %2 s gefunden, erwartet: eine Zeit nach %3 s</translation>
    </message>
    <message>
        <source>hand script: target %1 needs too high a speed</source>
        <translation>Handskript: Ziel %1 verlangt eine zu hohe Geschwindigkeit</translation>
    </message>
    <message>
        <source>the motion to play has no rows</source>
        <translation>die Bewegung, die gespielt werden soll, ist leer</translation>
    </message>
    <message>
        <source>%1 belongs to another user, expected you or root as its owner</source>
        <translation>%1 gehört einem anderen Benutzer, erwartet: Sie oder root als Eigentümer</translation>
    </message>
    <message>
        <source>others may write to %1; remove this permission with: chmod go-w &apos;%1&apos;</source>
        <translation>andere dürfen in %1 schreiben; nehmen Sie dieses Recht mit: chmod go-w &quot;%1&quot;</translation>
    </message>
    <message>
        <source>%1: skipped, %2</source>
        <translation>%1: übersprungen, %2</translation>
    </message>
    <message>
        <source>not a Qt plugin</source>
        <translation>kein Qt-Plugin</translation>
    </message>
    <message>
        <source>a plugin of another program: found &quot;%1&quot;, expected &quot;%2&quot;</source>
        <translation>ein Plugin eines anderen Programms: gefunden „%1“, erwartet „%2“</translation>
    </message>
    <message>
        <source>built for device API %1, this program has %2; rebuild it against this version</source>
        <translation>für Geräte-API %1 gebaut, dieses Programm hat %2; bauen Sie es gegen diese Version neu</translation>
    </message>
    <message>
        <source>found apiVersion %1 in its metadata, expected %2, which it was built for; correct its plugin.json and rebuild it</source>
        <translation>apiVersion %1 in den Metadaten gefunden, erwartet: %2, wofür es gebaut ist; berichtigen Sie plugin.json und bauen Sie es neu</translation>
    </message>
    <message>
        <source>found the id &quot;%1&quot; in its metadata, expected lowercase letters, digits and dashes</source>
        <translation>Kennung „%1“ in den Metadaten gefunden, erwartet: Kleinbuchstaben, Ziffern und Bindestriche</translation>
    </message>
    <message>
        <source>its id &quot;%1&quot; belongs to a built-in device</source>
        <translation>seine Kennung „%1“ gehört einem eingebauten Gerät</translation>
    </message>
    <message>
        <source>its metadata has no &quot;%1&quot;</source>
        <translation>den Metadaten fehlt „%1“</translation>
    </message>
    <message>
        <source>%1: skipped, %2 has the same id and comes first</source>
        <translation>%1: übersprungen, %2 hat dieselbe Kennung und kommt zuerst</translation>
    </message>
    <message>
        <source>%1: its root object is not a device plugin</source>
        <translation>%1: das Wurzelobjekt ist kein Geräte-Plugin</translation>
    </message>
    <message>
        <source>%1: skipped, it hung when it was started</source>
        <translation>%1: übersprungen, hing beim Start</translation>
    </message>
    <message>
        <source>%1: could not be tried: %2: %3</source>
        <translation>%1: konnte nicht geprüft werden: %2: %3</translation>
    </message>
    <message>
        <source>%1: skipped, it crashed when it was started (signal %2)</source>
        <translation>%1: übersprungen, beim Start abgestürzt (Signal %2)</translation>
    </message>
    <message>
        <source>%1: skipped, it ended the process when it was started</source>
        <translation>%1: übersprungen, beendete den Prozess beim Start</translation>
    </message>
    <message>
        <source>%1: skipped, it failed when it was started: %2</source>
        <translation>%1: übersprungen, schlug beim Start fehl: %2</translation>
    </message>
    <message>
        <source>%1: skipped, it failed when it was started</source>
        <translation>%1: übersprungen, schlug beim Start fehl</translation>
    </message>
    <message>
        <source>simulated hand: %1: found %2, expected at least %3</source>
        <translation>simulierte Hand: %1: gefunden %2, erwartet mindestens %3</translation>
    </message>
    <message>
        <source>simulated hand: %1: found %2, expected at most %3</source>
        <translation>simulierte Hand: %1: gefunden %2, erwartet höchstens %3</translation>
    </message>
    <message>
        <source>found a mesh of %1 mm from its centre to its side, expected at most %2 mm</source>
        <translation>Netz mit %1 mm von der Mitte bis zur Seite gefunden, erwartet: höchstens %2 mm</translation>
    </message>
    <message>
        <source>is not deeper than the previous knot</source>
        <translation>ist nicht tiefer als die vorige</translation>
    </message>
    <message>
        <source>has a steeper slope than any law</source>
        <translation>ist steiler als jedes Gesetz</translation>
    </message>
    <message>
        <source>follows a cell with a force below 0</source>
        <translation>folgt auf eine Zelle mit einer Kraft unter 0</translation>
    </message>
    <message>
        <source>has a number that is not finite</source>
        <translation>enthält eine nicht endliche Zahl</translation>
    </message>
    <message>
        <source>is not at 0 mm and 0 N</source>
        <translation>liegt nicht bei 0 mm und 0 N</translation>
    </message>
    <message>
        <source>has a force below 0</source>
        <translation>hat eine Kraft unter 0</translation>
    </message>
    <message>
        <source>ends with a slope below 0 or steeper than any law</source>
        <translation>endet mit einer Steigung unter 0 oder steiler als jedes Gesetz</translation>
    </message>
    <message>
        <source>force table: found %1 knots, expected 1 to %2</source>
        <translation>Krafttabelle: %1 Stützstellen gefunden, erwartet: 1 bis %2</translation>
    </message>
    <message>
        <source>force table: knot %1 of %2 %3</source>
        <translation>Krafttabelle: Stützstelle %1 von %2 %3</translation>
    </message>
    <message>
        <source>force table: found %1 bytes, expected %2 for each knot</source>
        <translation>Krafttabelle: %1 Bytes gefunden, erwartet: %2 je Stützstelle</translation>
    </message>
    <message>
        <source>%1: no such file, expected a mesh, a scene or a recording</source>
        <translation>%1: die Datei ist nicht da, erwartet: ein Netz, eine Szene oder eine Aufzeichnung</translation>
    </message>
    <message>
        <source>--size: found &quot;%1&quot;, expected width x height, as 1280x800</source>
        <translation>--size: gefunden „%1“, erwartet: Breite x Höhe, etwa 1280x800</translation>
    </message>
    <message>
        <source>%1: found nothing palpable, expected a surface to touch</source>
        <translation>%1: nichts Tastbares gefunden, erwartet: eine Oberfläche zum Tasten</translation>
    </message>
    <message>
        <source>%1: %2; expected a recording as it was written, or what session recover makes of it</source>
        <translation>%1: %2; erwartet: eine unveränderte Aufzeichnung oder ihre Kopie von session recover</translation>
    </message>
    <message>
        <source>evaluate: found no SCENE and no bundled phantom, expected a mesh or a scene file</source>
        <translation>evaluate: keine SCENE und kein mitgeliefertes Phantom gefunden, erwartet: ein Netz oder eine Szenendatei</translation>
    </message>
    <message>
        <source>--out: %1 cannot be made: %2</source>
        <translation>--out: %1 kann nicht angelegt werden: %2</translation>
    </message>
    <message>
        <source>--felt: found %1, expected no SCENE</source>
        <translation>--felt: gefunden %1, erwartet: keine SCENE</translation>
    </message>
    <message>
        <source>found &quot;%1&quot;, expected a whole number from %2 to %3</source>
        <translation>gefunden „%1“, erwartet: eine ganze Zahl von %2 bis %3</translation>
    </message>
    <message>
        <source>--ratio: found &quot;%1&quot;, expected NAME=R, as &quot;lump 12 mm=4.4&quot;</source>
        <translation>--ratio: gefunden „%1“, erwartet: NAME=R, etwa „lump 12 mm=4.4“</translation>
    </message>
    <message>
        <source>--ratio: found %1 twice, expected once</source>
        <translation>--ratio: %1 zweimal gefunden, erwartet: einmal</translation>
    </message>
    <message>
        <source>%1: found neither a scene nor a recording, expected a file that keeps findings (.palpate.json or .palpate)</source>
        <translation>%1: weder eine Szene noch eine Aufzeichnung, erwartet: eine Datei mit Befunden (.palpate.json oder .palpate)</translation>
    </message>
    <message>
        <source>stdout: the findings could not be written</source>
        <translation>stdout: die Befunde konnten nicht geschrieben werden</translation>
    </message>
    <message>
        <source>findings --import: found %1, expected a scene (.palpate.json)</source>
        <translation>findings --import: gefunden %1, erwartet: eine Szene (.palpate.json)</translation>
    </message>
    <message>
        <source>findings: found one of --import and --out, expected both: the scene with what is taken is another file</source>
        <translation>findings: nur eine der Optionen --import und --out gefunden, erwartet: beide, denn die Szene mit den übernommenen Befunden ist eine andere Datei</translation>
    </message>
    <message>
        <source>findings: found - for --csv and --markups, expected it for one</source>
        <translation>findings: - für --csv und --markups gefunden, erwartet: nur für eine von beiden</translation>
    </message>
    <message>
        <source>findings --import: found --csv or --markups too, expected --out alone: export from there</source>
        <translation>findings --import: auch --csv oder --markups gefunden, erwartet: nur --out; exportieren Sie aus der neuen Szene</translation>
    </message>
    <message>
        <source>%1: %2, expected the program that does `palpate %3`: install it beside palpate, or build all of Palpate</source>
        <translation>%1: %2, erwartet: das Programm für `palpate %3`; installieren Sie es neben palpate oder bauen Sie ganz Palpate</translation>
    </message>
    <message>
        <source>%1: found after an option, expected as the first word after palpate</source>
        <translation>%1: nach einer Option gefunden, erwartet: als erstes Wort nach palpate</translation>
    </message>
    <message>
        <source>%1: no such file, expected a mesh, a scene or a folder</source>
        <translation>%1: die Datei ist nicht da, erwartet: ein Netz, eine Szene oder ein Ordner</translation>
    </message>
    <message>
        <source>%1: found a recording, expected a mesh (palpate session info reads recordings)</source>
        <translation>%1: eine Aufzeichnung gefunden, erwartet: ein Netz (palpate session info liest Aufzeichnungen)</translation>
    </message>
    <message>
        <source>%1: no such file, expected a mesh, a scene or a folder of meshes</source>
        <translation>%1: die Datei ist nicht da, erwartet: ein Netz, eine Szene oder ein Ordner mit Netzen</translation>
    </message>
    <message>
        <source>%1: no such file, expected a motion CSV or a recording</source>
        <translation>%1: die Datei ist nicht da, erwartet: eine Bewegung als CSV oder eine Aufzeichnung</translation>
    </message>
    <message>
        <source>%1: cannot be written: not a file; a recording is one, expected its name</source>
        <translation>%1: kann nicht geschrieben werden: keine Datei, erwartet: der Name einer Datei für die Aufzeichnung</translation>
    </message>
    <message>
        <source>%1: found a file of this name, expected a new one for the recording, or --force to replace it</source>
        <translation>%1: es gibt eine Datei dieses Namens, erwartet: ein neuer Name für die Aufzeichnung oder --force, um die Datei zu ersetzen</translation>
    </message>
    <message>
        <source>%1: found nothing palpable, expected a structure that is</source>
        <translation>%1: nichts Tastbares gefunden, erwartet: eine tastbare Struktur</translation>
    </message>
    <message>
        <source>%1: %2: this version does not know this field; it is kept, but not used</source>
        <translation>%1: %2: Dieses Feld ist dieser Version unbekannt; es bleibt erhalten, wird aber nicht verwendet</translation>
    </message>
    <message>
        <source>%1: structure &quot;%2&quot; was touched by itself in the recording (layer %3), here it is felt through the structure around it; expected the scene that was recorded, or --force to replay the motion alone</source>
        <translation>%1: die Struktur „%2“ wurde in der Aufzeichnung selbst berührt (Schicht %3), hier wird sie durch die Struktur um sie herum gefühlt; erwartet: die aufgezeichnete Szene oder --force, um nur die Bewegung zu wiederholen</translation>
    </message>
    <message>
        <source>%1: structure &quot;%2&quot; was touched by itself in the recording (layer %3), here it is not palpable; expected the scene that was recorded, or --force to replay the motion alone</source>
        <translation>%1: die Struktur „%2“ wurde in der Aufzeichnung selbst berührt (Schicht %3), hier ist sie nicht tastbar; erwartet: die aufgezeichnete Szene oder --force, um nur die Bewegung zu wiederholen</translation>
    </message>
    <message>
        <source>%1: %2; expected the scene that was recorded, or --force</source>
        <translation>%1: %2; erwartet: die aufgezeichnete Szene oder --force</translation>
    </message>
    <message>
        <source>%1: %2 ticks skipped: ticks before them are missing in the recording</source>
        <translation>%1: %2 Augenblicke übersprungen: in der Aufzeichnung fehlen Augenblicke davor</translation>
    </message>
    <message>
        <source>%1: %2 of %3 ticks were lost</source>
        <translation>%1: %2 von %3 Augenblicken gingen verloren</translation>
    </message>
    <message>
        <source>the safety gate took the force away: %1</source>
        <translation>die Sicherheitsabschaltung hat die Kraft weggenommen: %1</translation>
    </message>
    <message>
        <source>not computed again: %1; say where the scene is with --scene</source>
        <translation>nicht neu berechnet: %1; geben Sie mit --scene an, wo die Szene ist</translation>
    </message>
    <message>
        <source>%1: %2 ticks are missing and %3 after them could not be computed again</source>
        <translation>%1: %2 Augenblicke fehlen, und %3 danach konnten nicht neu berechnet werden</translation>
    </message>
    <message>
        <source>%1: found a file that is no recording, expected another name for the copy, or --force to replace it</source>
        <translation>%1: eine Datei, die keine Aufzeichnung ist, erwartet: ein anderer Name für die Kopie oder --force, um die Datei zu ersetzen</translation>
    </message>
    <message>
        <source>%1: no coverage of %2: %3; say where the scene is with --scene</source>
        <translation>%1: keine Abdeckung von %2: %3; geben Sie mit --scene an, wo die Szene ist</translation>
    </message>
    <message>
        <source>its surface is another one now</source>
        <translation>die Oberfläche ist jetzt eine andere</translation>
    </message>
    <message>
        <source>session export: found no output, expected --csv or --vtp</source>
        <translation>session export: keine Ausgabe gefunden, erwartet: --csv oder --vtp</translation>
    </message>
    <message>
        <source>--device: found &quot;%1&quot;, expected one of %2</source>
        <translation>--device: gefunden „%1“, erwartet: eines von %2</translation>
    </message>
    <message>
        <source>%1: found nothing to press, expected a palpable surface</source>
        <translation>%1: nichts zum Drücken gefunden, erwartet: eine tastbare Oberfläche</translation>
    </message>
    <message>
        <source>%1: a hand on %2 slips off it wherever it presses; is it the size it should be (--unit)?</source>
        <translation>%1: eine Hand mit %2 rutscht überall ab, wo sie drückt; stimmt die Größe (--unit)?</translation>
    </message>
    <message>
        <source>%1: DAMAGED, or changed after it was recorded, in 1 place: ticks that do not match their checksum were left out, and figures are those of the rest</source>
        <translation>%1: BESCHÄDIGT oder nach der Aufzeichnung geändert an 1 Stelle: Augenblicke, die nicht zu ihrer Prüfsumme passen, sind ausgelassen, und die Zahlen gelten für den Rest</translation>
    </message>
    <message>
        <source>%1: DAMAGED, or changed after it was recorded, in %2 places: ticks that do not match their checksum were left out, and figures are those of the rest</source>
        <translation>%1: BESCHÄDIGT oder nach der Aufzeichnung geändert an %2 Stellen: Augenblicke, die nicht zu ihrer Prüfsumme passen, sind ausgelassen, und die Zahlen gelten für den Rest</translation>
    </message>
    <message>
        <source>%1: and %2 more</source>
        <translation>%1: und %2 weitere</translation>
    </message>
    <message>
        <source>%1: %2; recorded by this build (%3)</source>
        <translation>%1: %2; mit dieser Programmfassung aufgezeichnet (%3)</translation>
    </message>
    <message>
        <source>%1: %2; recorded by another build (%3), this one is %4</source>
        <translation>%1: %2; mit einer anderen Programmfassung aufgezeichnet (%3), diese ist %4</translation>
    </message>
    <message>
        <source>%1: %2; recorded by this build (%3), which should give the same bits</source>
        <translation>%1: %2; mit dieser Programmfassung aufgezeichnet (%3), die dieselben Bits ergeben sollte</translation>
    </message>
    <message>
        <source>%1: cannot be written</source>
        <translation>%1: kann nicht geschrieben werden</translation>
    </message>
    <message>
        <source>%1: found &quot;%2&quot;, expected a number above %3</source>
        <translation>%1: gefunden „%2“, erwartet: eine Zahl über %3</translation>
    </message>
    <message>
        <source>%1: found &quot;%2&quot;, expected a number of at least %3</source>
        <translation>%1: gefunden „%2“, erwartet: eine Zahl von mindestens %3</translation>
    </message>
    <message>
        <source>%1: found &quot;%2&quot;, expected a number above %3 and at most %4</source>
        <translation>%1: gefunden „%2“, erwartet: eine Zahl über %3 und höchstens %4</translation>
    </message>
    <message>
        <source>%1: found &quot;%2&quot;, expected a number of at least %3 and at most %4</source>
        <translation>%1: gefunden „%2“, erwartet: eine Zahl von mindestens %3 und höchstens %4</translation>
    </message>
    <message>
        <source>--unit: found &quot;%1&quot;, expected m, cm or mm</source>
        <translation>--unit: gefunden „%1“, erwartet: m, cm oder mm</translation>
    </message>
    <message>
        <source>--frame: found &quot;%1&quot;, expected LPS, RAS or Y-up</source>
        <translation>--frame: gefunden „%1“, erwartet: LPS, RAS oder Y-up</translation>
    </message>
    <message>
        <source>%1: found it as input and output, expected another name for the output</source>
        <translation>%1: als Ein- und Ausgabe gefunden, erwartet: ein anderer Name für die Ausgabe</translation>
    </message>
    <message>
        <source>%1: found it as output and a file of %2, expected another name for the output</source>
        <translation>%1: als Ausgabe und Datei von %2 gefunden, erwartet: ein anderer Name für die Ausgabe</translation>
    </message>
    <message>
        <source>%1: found it as two outputs, expected a name for each</source>
        <translation>%1: für zwei Ausgaben gefunden, erwartet: für jede ein eigener Name</translation>
    </message>
    <message>
        <source>--plugin-path: %1: expected a folder</source>
        <translation>--plugin-path: %1: erwartet: ein Ordner</translation>
    </message>
    <message>
        <source>--layers: found &quot;%1&quot;, expected auto</source>
        <translation>--layers: gefunden „%1“, erwartet: auto</translation>
    </message>
    <message>
        <source>%1; meshes are read in this process</source>
        <translation>%1; Netze werden in diesem Prozess gelesen</translation>
    </message>
    <message>
        <source>out of memory</source>
        <translation>der Speicher reicht nicht</translation>
    </message>
    <message>
        <source>stopped by an unknown error</source>
        <translation>durch einen unbekannten Fehler beendet</translation>
    </message>
    <message>
        <source>the output could not be written</source>
        <translation>die Ausgabe konnte nicht geschrieben werden</translation>
    </message>
    <message>
        <source>%1 (palpate --help lists what there is)</source>
        <translation>%1 (palpate --help zeigt alle Möglichkeiten)</translation>
    </message>
    <message>
        <source>no picture after %1 s</source>
        <translation>kein Bild nach %1 s</translation>
    </message>
    <message>
        <source>%1: found a link, pipe or other special file, expected a file of settings; they are not kept. Remove it</source>
        <translation>%1: ein Link, eine Pipe oder eine andere besondere Datei, erwartet: eine Datei mit Einstellungen; sie werden nicht behalten. Entfernen Sie diese Datei</translation>
    </message>
    <message>
        <source>found no display (DISPLAY is not set), expected one for the window; app/run.sh draws without</source>
        <translation>keine Anzeige gefunden (DISPLAY ist nicht gesetzt), das Fenster braucht eine; app/run.sh zeichnet ohne Anzeige</translation>
    </message>
    <message>
        <source>the display (%1) has no OpenGL, expected one that has; app/run.sh draws without a display</source>
        <translation>die Anzeige (%1) hat kein OpenGL, erwartet: eine mit OpenGL; app/run.sh zeichnet ohne Anzeige</translation>
    </message>
    <message>
        <source>Stiffness</source>
        <translation>Steifigkeit</translation>
    </message>
    <message>
        <source>force per millimetre of depth</source>
        <translation>Kraft je Millimeter Tiefe</translation>
    </message>
    <message>
        <source>newton per millimetre</source>
        <translation>Newton je Millimeter</translation>
    </message>
    <message>
        <source>Damping</source>
        <translation>Dämpfung</translation>
    </message>
    <message>
        <source>resisting force per mm/s of movement</source>
        <translation>Gegenkraft je mm/s Bewegung</translation>
    </message>
    <message>
        <source>newton seconds per millimetre</source>
        <translation>Newtonsekunden je Millimeter</translation>
    </message>
    <message>
        <source>Static friction</source>
        <translation>Haftreibung</translation>
    </message>
    <message>
        <source>tangential force that starts sliding, as a fraction of the normal force</source>
        <translation>Tangentialkraft, ab der es gleitet, als Anteil der Normalkraft</translation>
    </message>
    <message>
        <source>Sliding friction</source>
        <translation>Gleitreibung</translation>
    </message>
    <message>
        <source>tangential force while sliding, as a fraction of the normal force</source>
        <translation>Tangentialkraft beim Gleiten, als Anteil der Normalkraft</translation>
    </message>
    <message>
        <source>Drag</source>
        <translation>Viskose Reibung</translation>
    </message>
    <message>
        <source>resisting force per mm/s of sliding</source>
        <translation>Gegenkraft je mm/s Gleiten</translation>
    </message>
    <message>
        <source>Initial stiffness</source>
        <translation>Anfangssteifigkeit</translation>
    </message>
    <message>
        <source>Growth with depth</source>
        <translation>Zunahme mit der Tiefe</translation>
    </message>
    <message>
        <source>Maximum stiffness</source>
        <translation>Maximale Steifigkeit</translation>
    </message>
    <message>
        <source>Young&apos;s modulus</source>
        <translation>Elastizitätsmodul</translation>
    </message>
    <message>
        <source>Ball radius</source>
        <translation>Kugelradius</translation>
    </message>
    <message>
        <source>Layer thickness</source>
        <translation>Schichtdicke</translation>
    </message>
    <message>
        <source>Bonded to the layer below</source>
        <translation>Mit der Schicht darunter verbunden</translation>
    </message>
    <message>
        <source>Stiffness before the click</source>
        <translation>Steifigkeit vor dem Klick</translation>
    </message>
    <message>
        <source>Force at the click</source>
        <translation>Kraft beim Klick</translation>
    </message>
    <message>
        <source>Force after the click</source>
        <translation>Kraft nach dem Klick</translation>
    </message>
    <message>
        <source>Depth of the force drop</source>
        <translation>Tiefe des Kraftabfalls</translation>
    </message>
    <message>
        <source>Stiffness after the click</source>
        <translation>Steifigkeit nach dem Klick</translation>
    </message>
    <message>
        <source>This device needs no calibration.</source>
        <translation>Dieses Gerät braucht keine Kalibrierung.</translation>
    </message>
    <message>
        <source>%1: cannot be made: %2</source>
        <translation>%1: kann nicht angelegt werden: %2</translation>
    </message>
    <message>
        <source>The device gave a position that is not a number. Check its driver, then re-arm.</source>
        <translation>Das Gerät gab eine Position an, die keine Zahl ist. Bitte den Treiber prüfen, dann wieder fühlen.</translation>
    </message>
    <message>
        <source>The device gave positions outside its workspace. Calibrate it, then re-arm.</source>
        <translation>Das Gerät gab Positionen außerhalb seines Arbeitsraums an. Bitte kalibrieren, dann wieder fühlen.</translation>
    </message>
    <message>
        <source>The device&apos;s position jumped farther than a hand can move. Check its cable and calibration, then re-arm.</source>
        <translation>Die Position des Geräts sprang weiter, als eine Hand sich bewegen kann. Bitte Kabel und Kalibrierung prüfen, dann wieder fühlen.</translation>
    </message>
    <message>
        <source>The device stopped giving new positions. Check its connection, then re-arm.</source>
        <translation>Das Gerät gibt keine neuen Positionen mehr an. Bitte die Verbindung prüfen, dann wieder fühlen.</translation>
    </message>
    <message>
        <source>The device no longer answers. Plug it in again, then re-arm.</source>
        <translation>Das Gerät antwortet nicht mehr. Bitte neu einstecken, dann wieder fühlen.</translation>
    </message>
    <message>
        <source>The model gave a force that is not a number. Leave the surface, then re-arm.</source>
        <translation>Die berechnete Kraft ist keine Zahl. Bitte die Oberfläche verlassen, dann wieder fühlen.</translation>
    </message>
    <message>
        <source>The computer could not keep the servo rate. Close other programs or lower the rate, then re-arm.</source>
        <translation>Der Rechner hielt den Takt nicht ein. Bitte andere Programme schließen oder den Takt senken, dann wieder fühlen.</translation>
    </message>
    <message>
        <source>The servo thread ended by an error. Start the device again.</source>
        <translation>Die Berechnung der Kraft endete durch einen Fehler. Bitte das Gerät neu starten.</translation>
    </message>
    <message>
        <source>real-time priority</source>
        <translation>Echtzeit-Priorität</translation>
    </message>
    <message>
        <source>locked memory</source>
        <translation>gesperrter Speicher</translation>
    </message>
    <message>
        <source>SCHED_FIFO %1</source>
        <translation>SCHED_FIFO %1</translation>
    </message>
    <message>
        <source>SCHED_FIFO %1 was refused: %2</source>
        <translation>SCHED_FIFO %1 wurde verweigert: %2</translation>
    </message>
    <message>
        <source>mlockall was refused: %1</source>
        <translation>mlockall wurde verweigert: %1</translation>
    </message>
    <message>
        <source>only %1 KiB may be locked: %2</source>
        <translation>nur %1 KiB dürfen gesperrt werden: %2</translation>
    </message>
    <message>
        <source>pages stay in memory once touched</source>
        <translation>Seiten bleiben im Speicher, sobald sie benutzt wurden</translation>
    </message>
    <message>
        <source>CPU %1: the program may not run on it (see taskset -p, or the container&apos;s settings), expected one of %2</source>
        <translation>Prozessor %1: das Programm darf darauf nicht laufen (siehe taskset -p oder die Einstellungen des Containers), erwartet: einer von %2</translation>
    </message>
    <message>
        <source>CPU %1: this machine has no such CPU, expected one of %2</source>
        <translation>Prozessor %1: diesen gibt es hier nicht, erwartet: einer von %2</translation>
    </message>
    <message>
        <source>thread name</source>
        <translation>Name des Threads</translation>
    </message>
    <message>
        <source>&quot;%1&quot;</source>
        <translation>„%1“</translation>
    </message>
    <message>
        <source>not asked for</source>
        <translation>nicht verlangt</translation>
    </message>
    <message>
        <source>timer slack</source>
        <translation>Zeitgeber-Toleranz</translation>
    </message>
    <message>
        <source>%1 ns</source>
        <translation>%1 ns</translation>
    </message>
    <message>
        <source>own CPU</source>
        <translation>eigener Prozessor</translation>
    </message>
    <message>
        <source>CPU %1</source>
        <translation>Prozessor %1</translation>
    </message>
    <message>
        <source>CPU %1 was refused: %2</source>
        <translation>Prozessor %1 wurde verweigert: %2</translation>
    </message>
    <message>
        <source>floating point</source>
        <translation>Gleitkomma</translation>
    </message>
    <message>
        <source>default environment, denormals kept: a replay gives the same bits</source>
        <translation>Standardumgebung mit denormalen Zahlen: eine Wiederholung ergibt dieselben Bits</translation>
    </message>
    <message>
        <source>the default environment could not be set</source>
        <translation>die Standardumgebung ließ sich nicht einstellen</translation>
    </message>
    <message>
        <source>servo rate is %1 Hz, expected 1 to 10000</source>
        <translation>der Takt ist %1 Hz, erwartet: 1 bis 10000</translation>
    </message>
    <message>
        <source>the servo ring holds %1 ticks, expected 2 to %2</source>
        <translation>der Ringpuffer fasst %1 Augenblicke, erwartet: 2 bis %2</translation>
    </message>
    <message>
        <source>the servo loop is already running</source>
        <translation>die Hand läuft schon</translation>
    </message>
    <message>
        <source>the device could not be started: %1</source>
        <translation>das Gerät ließ sich nicht starten: %1</translation>
    </message>
    <message>
        <source>the device could not be started: its driver failed</source>
        <translation>das Gerät ließ sich nicht starten: sein Treiber versagte</translation>
    </message>
    <message>
        <source>the servo loop is not running</source>
        <translation>die Hand läuft nicht</translation>
    </message>
    <message>
        <source>the device or the servo thread could not be started: %1</source>
        <translation>das Gerät oder der Servo-Thread ließ sich nicht starten: %1</translation>
    </message>
    <message>
        <source>the servo thread could not be set up</source>
        <translation>der Servo-Thread ließ sich nicht einrichten</translation>
    </message>
    <message>
        <source>file is not a database</source>
        <translation>die Datei ist keine Datenbank</translation>
    </message>
    <message>
        <source>database disk image is malformed</source>
        <translation>die Datenbank ist beschädigt</translation>
    </message>
    <message>
        <source>unable to open database file</source>
        <translation>die Datei kann nicht geöffnet werden</translation>
    </message>
    <message>
        <source>database or disk is full</source>
        <translation>der Datenträger ist voll</translation>
    </message>
    <message>
        <source>attempt to write a readonly database</source>
        <translation>die Datei ist schreibgeschützt</translation>
    </message>
    <message>
        <source>disk I/O error</source>
        <translation>der Datenträger antwortet nicht richtig</translation>
    </message>
    <message>
        <source>%1: found a database with a write-ahead log, expected one with a rollback journal, as Palpate writes it: another program changed it</source>
        <translation>%1: eine Datenbank mit Write-Ahead-Log, erwartet wurde eine mit Rollback-Journal, wie Palpate sie schreibt: Ein anderes Programm hat sie geändert</translation>
    </message>
    <message>
        <source>the disk is full</source>
        <translation>der Datenträger ist voll</translation>
    </message>
    <message>
        <source>its pages lead to more rows than a file of its size holds</source>
        <translation>die Seiten führen zu mehr Zeilen, als eine Datei dieser Größe enthält</translation>
    </message>
    <message>
        <source>%1: cannot be read: %2</source>
        <translation>%1: kann nicht gelesen werden: %2</translation>
    </message>
    <message>
        <source>%1: cannot be written: %2</source>
        <translation>%1: kann nicht geschrieben werden: %2</translation>
    </message>
    <message>
        <source>%1: found something else than a file, expected the journal of a recording; nothing was opened. Move it away to read the recording as it is</source>
        <translation>%1: keine Datei, erwartet wurde das Journal einer Aufzeichnung; nichts wurde geöffnet. Verschieben Sie es, um die Aufzeichnung so zu lesen, wie sie ist</translation>
    </message>
    <message>
        <source>%1: found the journal of several databases, which names another file to be deleted; Palpate writes none, so this was not made by Palpate; nothing was opened. Move it away to read the recording as it is</source>
        <translation>%1: das Journal mehrerer Datenbanken, das eine andere Datei zum Löschen nennt; Palpate schreibt keines, es stammt also nicht von Palpate; nichts wurde geöffnet. Verschieben Sie es, um die Aufzeichnung so zu lesen, wie sie ist</translation>
    </message>
    <message>
        <source>a temporary file</source>
        <translation>eine temporäre Datei</translation>
    </message>
    <message>
        <source>it asks to open %1, expected nothing but the recording and its journal</source>
        <translation>sie verlangt, %1 zu öffnen, erwartet: nur die Aufzeichnung und ihr Journal</translation>
    </message>
    <message>
        <source>it asks to delete %1, expected nothing but the recording and its journal</source>
        <translation>sie verlangt, %1 zu löschen, erwartet: nur die Aufzeichnung und ihr Journal</translation>
    </message>
    <message>
        <source>its journal holds more than a recorder changes at a time</source>
        <translation>das Journal enthält mehr, als eine Aufzeichnung auf einmal ändert</translation>
    </message>
    <message>
        <source>distance: found %1 mm, expected at least %2 mm for surfaces this large</source>
        <translation>Abstand: gefunden %1 mm, erwartet: mindestens %2 mm bei Oberflächen dieser Größe</translation>
    </message>
    <message>
        <source>measuring was cancelled</source>
        <translation>die Auswertung wurde abgebrochen</translation>
    </message>
    <message>
        <source>the disk cannot be written (%1)</source>
        <translation>der Datenträger kann nicht beschrieben werden: %1</translation>
    </message>
    <message>
        <source>%1: the recording ended at %2 s because %3; what was felt after is not in it</source>
        <translation>%1: die Aufzeichnung endete bei %2 s (%3); was danach gefühlt wurde, ist nicht darin</translation>
    </message>
    <message>
        <source>%1: nothing was recorded because %2</source>
        <translation>%1: nichts wurde aufgezeichnet (%2)</translation>
    </message>
    <message>
        <source>%1: recording ended: %2</source>
        <translation>%1: die Aufzeichnung endete: %2</translation>
    </message>
    <message>
        <source>%1: is still being recorded</source>
        <translation>%1: wird noch aufgezeichnet</translation>
    </message>
    <message>
        <source>%1: cannot be recorded: the servo loop is not running</source>
        <translation>%1: kann nicht aufgezeichnet werden: die Hand läuft nicht</translation>
    </message>
    <message>
        <source>%1: cannot be recorded: the servo loop does not answer</source>
        <translation>%1: kann nicht aufgezeichnet werden: die Hand antwortet nicht</translation>
    </message>
    <message>
        <source>%1: %2 ticks were lost</source>
        <translation>%1: %2 Augenblicke gingen verloren</translation>
    </message>
    <message>
        <source>%1: no such file, expected a recording</source>
        <translation>%1: die Datei ist nicht da, erwartet: eine Aufzeichnung</translation>
    </message>
    <message>
        <source>%1: cannot be opened: %2</source>
        <translation>%1: kann nicht geöffnet werden: %2</translation>
    </message>
    <message>
        <source>%1: found no SQLite database, expected a recording</source>
        <translation>%1: keine Aufzeichnung von Palpate (keine SQLite-Datenbank)</translation>
    </message>
    <message>
        <source>%1: found no tick with a hand, expected at least one</source>
        <translation>%1: kein Augenblick mit einer Hand darin, erwartet: mindestens einer</translation>
    </message>
    <message>
        <source>%1 (and %2 more places)</source>
        <translation>%1 (und %2 weitere Stellen)</translation>
    </message>
    <message>
        <source>%1: damaged: %2</source>
        <translation>%1: beschädigt: %2</translation>
    </message>
    <message>
        <source>complete</source>
        <translation>vollständig</translation>
    </message>
    <message>
        <source>ended at %1 s because the disk was full; what was felt after is not in it</source>
        <translation>endete bei %1 s, weil der Datenträger voll war; was danach gefühlt wurde, ist nicht darin</translation>
    </message>
    <message>
        <source>ended at %1 s because the disk could not be written; what was felt after is not in it</source>
        <translation>endete bei %1 s, weil der Datenträger nicht beschrieben werden konnte; was danach gefühlt wurde, ist nicht darin</translation>
    </message>
    <message>
        <source>ended at %1 s without being closed (a crash, or a full disk); what was felt after is not in it</source>
        <translation>endete bei %1 s, ohne geschlossen zu werden (ein Absturz oder ein voller Datenträger); was danach gefühlt wurde, ist nicht darin</translation>
    </message>
    <message>
        <source>tick %1 after tick %2: ticks must ascend</source>
        <translation>Augenblick %1 nach Augenblick %2: Augenblicke müssen aufsteigen</translation>
    </message>
    <message>
        <source>the disk takes no more: %1 ticks lost</source>
        <translation>der Datenträger nimmt nichts mehr auf: %1 Augenblicke verloren</translation>
    </message>
    <message>
        <source>scene %1 is described already</source>
        <translation>Szene %1 ist schon beschrieben</translation>
    </message>
    <message>
        <source>its first page is damaged</source>
        <translation>die erste Seite ist beschädigt</translation>
    </message>
    <message>
        <source>%1: is the recording itself, expected another name</source>
        <translation>%1: ist die Aufzeichnung selbst, erwartet: ein anderer Name</translation>
    </message>
    <message>
        <source>%1: cannot be written: not a file</source>
        <translation>%1: kann nicht geschrieben werden: keine Datei</translation>
    </message>
    <message>
        <source>found no SQLite database, expected a recording</source>
        <translation>keine Aufzeichnung von Palpate (keine SQLite-Datenbank)</translation>
    </message>
    <message>
        <source>%1: %2 rows were gathered from the file&apos;s %3 pages one by one</source>
        <translation>%1: %2 Zeilen wurden einzeln aus den %3 Seiten der Datei gerettet</translation>
    </message>
    <message>
        <source>%1: %2: nothing can be recovered</source>
        <translation>%1: %2: nichts lässt sich retten</translation>
    </message>
    <message>
        <source>metadata: %1 cannot be read; set to their defaults</source>
        <translation>Metadaten: %1 nicht lesbar; auf die Vorgaben gesetzt</translation>
    </message>
    <message>
        <source>scene %1: left out</source>
        <translation>Szene %1: ausgelassen</translation>
    </message>
    <message>
        <source>tick %1: found a time before the first tick&apos;s: left out</source>
        <translation>Augenblick %1: eine Zeit vor der des ersten: ausgelassen</translation>
    </message>
    <message>
        <source>%1: left out</source>
        <translation>%1: ausgelassen</translation>
    </message>
    <message>
        <source>the end: the recording was not closed; nothing is known after tick %1</source>
        <translation>das Ende: die Aufzeichnung wurde nicht geschlossen; nach Augenblick %1 ist nichts bekannt</translation>
    </message>
    <message>
        <source>scene generation %1 is not described in the recording</source>
        <translation>die Szene %1 ist in der Aufzeichnung nicht beschrieben</translation>
    </message>
    <message>
        <source>the state before the first tick: found contact with triangle %1 of structure %2, expected one of the scene&apos;s layer %3</source>
        <translation>der Zustand vor dem ersten Augenblick: Kontakt mit Dreieck %1 der Struktur %2 gefunden, erwartet: eines der Schicht %3 der Szene</translation>
    </message>
    <message>
        <source>tick %1: god-object recorded at %2, now %3, %4 mm apart</source>
        <translation>Augenblick %1: Kontaktpunkt aufgezeichnet bei %2, jetzt %3, Abstand %4 mm</translation>
    </message>
    <message>
        <source>tick %1: force recorded as %2, now %3, %4 N apart</source>
        <translation>Augenblick %1: Kraft aufgezeichnet als %2, jetzt %3, Unterschied %4 N</translation>
    </message>
    <message>
        <source>tick %1: structure, triangle and constraints recorded as %2, now %3</source>
        <translation>Augenblick %1: Struktur, Dreieck und Bedingungen aufgezeichnet als %2, jetzt %3</translation>
    </message>
    <message>
        <source>tick %1: layers (structure, triangle, friction) recorded as %2, now %3</source>
        <translation>Augenblick %1: Schichten (Struktur, Dreieck, Reibung) aufgezeichnet als %2, jetzt %3</translation>
    </message>
    <message>
        <source>none</source>
        <translation>nichts</translation>
    </message>
    <message>
        <source>a map of its tissue has %1 triangles, expected %2</source>
        <translation>eine Karte ihres Gewebes hat %1 Dreiecke, erwartet: %2</translation>
    </message>
    <message>
        <source>structure &quot;%1&quot; of the recording: law_table: %2</source>
        <translation>Struktur „%1“ der Aufzeichnung: law_table: %2</translation>
    </message>
    <message>
        <source>structure &quot;%1&quot; of the recording: its geometry (SHA-256 %2...) is not in the scene</source>
        <translation>Struktur „%1“ der Aufzeichnung: ihre Geometrie (SHA-256 %2...) ist nicht in der Szene</translation>
    </message>
    <message>
        <source>structure &quot;%1&quot; of the recording: %2</source>
        <translation>Struktur „%1“ der Aufzeichnung: %2</translation>
    </message>
    <message>
        <source>found a fingertip radius of %1 mm in the recording, expected 0 to %2</source>
        <translation>ein Fingerradius von %1 mm in der Aufzeichnung, erwartet: 0 bis %2</translation>
    </message>
    <message>
        <source>found %1, expected an ascending range from 0 to 2^53</source>
        <translation>gefunden: %1, erwartet: ein aufsteigender Bereich von 0 bis 2^53</translation>
    </message>
    <message>
        <source>%1: found a checksum of %2 rows, expected at least one and at most one a tick</source>
        <translation>%1: eine Prüfsumme über %2 Zeilen, erwartet: mindestens eine und höchstens eine je Augenblick</translation>
    </message>
    <message>
        <source>found %1 rows, expected %2</source>
        <translation>%1 Zeilen gefunden, erwartet: %2</translation>
    </message>
    <message>
        <source>%1: found rows without a checksum</source>
        <translation>%1: Zeilen ohne Prüfsumme gefunden</translation>
    </message>
    <message>
        <source>%1: found without a checksum</source>
        <translation>%1: ohne Prüfsumme gefunden</translation>
    </message>
    <message>
        <source>scene %1</source>
        <translation>Szene %1</translation>
    </message>
    <message>
        <source>ticks %1 to %2</source>
        <translation>Augenblicke %1 bis %2</translation>
    </message>
    <message>
        <source>checks: found line %1, expected %2: a part of the recording was taken out</source>
        <translation>Prüfsummen: Zeile %1 gefunden, erwartet: %2; ein Teil der Aufzeichnung wurde entfernt</translation>
    </message>
    <message>
        <source>metadata</source>
        <translation>Metadaten</translation>
    </message>
    <message>
        <source>checks: found a line of kind &quot;%1&quot;, expected one of this version</source>
        <translation>Prüfsummen: eine Zeile der Art „%1“, erwartet: eine dieser Version</translation>
    </message>
    <message>
        <source>events %1 to %2</source>
        <translation>Ereignisse %1 bis %2</translation>
    </message>
    <message>
        <source>%1: found a second checksum, expected one</source>
        <translation>%1: eine zweite Prüfsumme gefunden, erwartet: eine</translation>
    </message>
    <message>
        <source>checks: %1</source>
        <translation>Prüfsummen: %1</translation>
    </message>
    <message>
        <source>checks: %1: found behind %2, expected ascending ranges</source>
        <translation>Prüfsummen: %1: hinter %2 gefunden, erwartet: aufsteigende Bereiche</translation>
    </message>
    <message>
        <source>event %1</source>
        <translation>Ereignis %1</translation>
    </message>
    <message>
        <source>tick %1: found a row without a checksum, expected ticks from 0</source>
        <translation>Augenblick %1: eine Zeile ohne Prüfsumme, erwartet: Augenblicke ab 0</translation>
    </message>
    <message>
        <source>%1: found other bits than were written (checksum)</source>
        <translation>%1: andere Bits, als geschrieben wurden (Prüfsumme)</translation>
    </message>
    <message>
        <source>metadata or %1</source>
        <translation>Metadaten oder %1</translation>
    </message>
    <message>
        <source>found %1 there</source>
        <translation>dort gefunden: %1</translation>
    </message>
    <message>
        <source>%1: cannot be read</source>
        <translation>%1: kann nicht gelesen werden</translation>
    </message>
    <message>
        <source>there is a file of this name; choose another name</source>
        <translation>es gibt eine Datei dieses Namens; wählen Sie einen anderen Namen</translation>
    </message>
    <message>
        <source>the file %1 would be taken for a part of it; move that away or choose another name</source>
        <translation>die Datei %1 würde für einen Teil davon gehalten; verschieben Sie sie oder wählen Sie einen anderen Namen</translation>
    </message>
    <message>
        <source>another program is recording into it; choose another name</source>
        <translation>ein anderes Programm zeichnet darin auf; wählen Sie einen anderen Namen</translation>
    </message>
    <message>
        <source>another program wrote a file of this name meanwhile; kept as %1</source>
        <translation>ein anderes Programm hat inzwischen eine Datei dieses Namens geschrieben; gespeichert als %1</translation>
    </message>
    <message>
        <source>found more than %1 %2, or more bytes of them than the file has, expected what a recorder writes</source>
        <translation>mehr als %1 %2 gefunden oder mehr Bytes davon, als die Datei hat, erwartet: was eine Aufzeichnung schreibt</translation>
    </message>
    <message>
        <source>found another program&apos;s SQLite database, expected a Palpate recording</source>
        <translation>die Datenbank eines anderen Programms, erwartet: eine Aufzeichnung von Palpate</translation>
    </message>
    <message>
        <source>found a recording of version %1, expected 1 to %2: damaged</source>
        <translation>eine Aufzeichnung der Version %1, erwartet: 1 bis %2; beschädigt</translation>
    </message>
    <message>
        <source>found a recording of version %1, expected at most %2: a newer Palpate made it</source>
        <translation>eine Aufzeichnung der Version %1, erwartet höchstens %2: eine neuere Fassung von Palpate hat sie geschrieben</translation>
    </message>
    <message>
        <source>values of the metadata</source>
        <translation>Werte der Metadaten</translation>
    </message>
    <message>
        <source>found %1 for %2, expected %3 to %4</source>
        <translation>gefunden: %1 für %2, erwartet: %3 bis %4</translation>
    </message>
    <message>
        <source>found the layer %1, expected one from 0</source>
        <translation>die Schicht %1 gefunden, erwartet: eine ab 0</translation>
    </message>
    <message>
        <source>found no mesh with a unit, expected one of the recording&apos;s meshes</source>
        <translation>kein Netz mit einer Einheit gefunden, erwartet: eines der Netze der Aufzeichnung</translation>
    </message>
    <message>
        <source>found the scene %1, expected ascending generations of 32 bits</source>
        <translation>die Szene %1 gefunden, erwartet: aufsteigende Nummern mit 32 Bits</translation>
    </message>
    <message>
        <source>scene %1: %2</source>
        <translation>Szene %1: %2</translation>
    </message>
    <message>
        <source>scenes</source>
        <translation>Szenen</translation>
    </message>
    <message>
        <source>structures</source>
        <translation>Strukturen</translation>
    </message>
    <message>
        <source>found the law %1, expected one of this version</source>
        <translation>das Gesetz %1 gefunden, erwartet: eines dieser Version</translation>
    </message>
    <message>
        <source>scene %1, structure &quot;%2&quot;: %3</source>
        <translation>Szene %1, Struktur „%2“: %3</translation>
    </message>
    <message>
        <source>event %1: found values of another type or a tick out of range, expected a tick, a kind and its text: left out</source>
        <translation>Ereignis %1: Werte einer anderen Art oder ein Augenblick außerhalb des Bereichs, erwartet: ein Augenblick, eine Art und ihr Text; ausgelassen</translation>
    </message>
    <message>
        <source>events</source>
        <translation>Ereignisse</translation>
    </message>
    <message>
        <source>lines of checks</source>
        <translation>Zeilen mit Prüfsummen</translation>
    </message>
    <message>
        <source>tick %1: found behind tick %2, expected ascending ticks: damaged</source>
        <translation>Augenblick %1: hinter Augenblick %2 gefunden, erwartet: aufsteigende Augenblicke; beschädigt</translation>
    </message>
    <message>
        <source>tick %1: %2</source>
        <translation>Augenblick %1: %2</translation>
    </message>
    <message>
        <source>embedded surface %1...: is not in the recording</source>
        <translation>eingebettete Oberfläche %1...: ist nicht in der Aufzeichnung</translation>
    </message>
    <message>
        <source>embedded surface %1...: found other bits than were written (checksum)</source>
        <translation>eingebettete Oberfläche %1...: andere Bits, als geschrieben wurden (Prüfsumme)</translation>
    </message>
    <message>
        <source>embedded surface %1...: found indices or coordinates out of range, expected triangles of three vertices within 10⁷ mm</source>
        <translation>eingebettete Oberfläche %1...: Indizes oder Koordinaten außerhalb des Bereichs, erwartet: Dreiecke aus drei Ecken innerhalb von 10⁷ mm</translation>
    </message>
    <message>
        <source>found more than %1 tables and views, expected the tables of a recording</source>
        <translation>mehr als %1 Tabellen und Sichten gefunden, erwartet: die Tabellen einer Aufzeichnung</translation>
    </message>
    <message>
        <source>found &quot;%1&quot; for %2 &quot;%3&quot;, expected only the tables of version %4 and the view tick_values</source>
        <translation>„%1“ für %2 „%3“ gefunden, erwartet: nur die Tabellen der Version %4 und die Sicht tick_values</translation>
    </message>
    <message>
        <source>found no table &quot;%1&quot;, expected the tables of version %2</source>
        <translation>keine Tabelle „%1“ gefunden, erwartet: die Tabellen der Version %2</translation>
    </message>
    <message>
        <source>found other columns in the table &quot;%1&quot;, expected those of version %2</source>
        <translation>andere Spalten in der Tabelle „%1“ gefunden, erwartet: die der Version %2</translation>
    </message>
    <message>
        <source>meta has no value &quot;%1&quot;</source>
        <translation>in meta fehlt der Wert „%1“</translation>
    </message>
    <message>
        <source>meta value &quot;%1&quot; is not a valid number, expected %2 to %3</source>
        <translation>der Wert „%1“ in meta ist keine gültige Zahl, erwartet: %2 bis %3</translation>
    </message>
    <message>
        <source>meta value &quot;%1&quot; is not a whole number</source>
        <translation>der Wert „%1“ in meta ist keine ganze Zahl</translation>
    </message>
    <message>
        <source>meta value &quot;%1&quot; is %2, expected %3 to %4</source>
        <translation>der Wert „%1“ in meta ist %2, erwartet: %3 bis %4</translation>
    </message>
    <message>
        <source>meta value &quot;dt_s&quot; is not one period of &quot;rate_Hz&quot;</source>
        <translation>der Wert „dt_s“ in meta ist keine Periode von „rate_Hz“</translation>
    </message>
    <message>
        <source>meta value &quot;start&quot; is not a state of this version</source>
        <translation>der Wert „start“ in meta ist kein Zustand dieser Version</translation>
    </message>
    <message>
        <source>found more than %1 bytes without a line end, expected a CSV</source>
        <translation>mehr als %1 Bytes ohne Zeilenende gefunden, erwartet: eine CSV-Datei</translation>
    </message>
    <message>
        <source>found no rows after the header, expected one a servo tick</source>
        <translation>keine Zeilen nach der Kopfzeile gefunden, erwartet: eine je Augenblick</translation>
    </message>
    <message>
        <source>%1: line %2: %3</source>
        <translation>%1: Zeile %2: %3</translation>
    </message>
    <message>
        <source>%1: line %2, column %3: %4</source>
        <translation>%1: Zeile %2, Spalte %3: %4</translation>
    </message>
    <message>
        <source>found 1 field, expected %1 as in the header</source>
        <translation>1 Feld gefunden, erwartet: %1 wie in der Kopfzeile</translation>
    </message>
    <message>
        <source>found %1 fields, expected %2 as in the header</source>
        <translation>%1 Felder gefunden, erwartet: %2 wie in der Kopfzeile</translation>
    </message>
    <message>
        <source>found an empty line, expected a header with x, y and z</source>
        <translation>eine leere Zeile gefunden, erwartet: eine Kopfzeile mit x, y und z</translation>
    </message>
    <message>
        <source>found the column twice, expected it once</source>
        <translation>die Spalte zweimal gefunden, erwartet: einmal</translation>
    </message>
    <message>
        <source>found no column %1 in %2, expected a header with x, y and z</source>
        <translation>keine Spalte %1 in %2 gefunden, erwartet: eine Kopfzeile mit x, y und z</translation>
    </message>
    <message>
        <source>found more than %1 rows, expected at most a day at 1 kHz: split the file</source>
        <translation>mehr als %1 Zeilen gefunden, erwartet: höchstens ein Tag mit 1 kHz; teilen Sie die Datei</translation>
    </message>
    <message>
        <source>found %1, expected a number</source>
        <translation>gefunden: %1, erwartet: eine Zahl</translation>
    </message>
    <message>
        <source>found %1, expected a finite number</source>
        <translation>gefunden: %1, erwartet: eine endliche Zahl</translation>
    </message>
    <message>
        <source>found %1, expected a coordinate within 10⁹ mm</source>
        <translation>gefunden: %1, erwartet: eine Koordinate innerhalb von 10⁹ mm</translation>
    </message>
    <message>
        <source>found a time before the previous row&apos;s, expected ascending times</source>
        <translation>eine Zeit vor der der vorigen Zeile, erwartet: aufsteigende Zeiten</translation>
    </message>
    <message>
        <source>found that no time passes, expected ascending times</source>
        <translation>es vergeht keine Zeit, erwartet: aufsteigende Zeiten</translation>
    </message>
    <message>
        <source>found %1 s between rows on average, expected 0.00001 to 1 s: one row a servo tick</source>
        <translation>im Mittel %1 s zwischen den Zeilen, erwartet: 0,00001 bis 1 s; eine Zeile je Augenblick</translation>
    </message>
    <message>
        <source>%1: no such file, expected a motion CSV</source>
        <translation>%1: die Datei ist nicht da, erwartet: eine Bewegung als CSV</translation>
    </message>
    <message>
        <source>%1: cannot be read: %2, expected a motion CSV</source>
        <translation>%1: kann nicht gelesen werden: %2, erwartet: eine Bewegung als CSV</translation>
    </message>
    <message>
        <source>%1: found a directory, expected a motion CSV</source>
        <translation>%1: ein Ordner, erwartet: eine Bewegung als CSV</translation>
    </message>
    <message>
        <source>a number within %1</source>
        <translation>eine Zahl bis %1</translation>
    </message>
    <message>
        <source>a whole number from %1 to %2</source>
        <translation>eine ganze Zahl von %1 bis %2</translation>
    </message>
    <message>
        <source>three numbers or none</source>
        <translation>drei Zahlen oder keine</translation>
    </message>
    <message>
        <source>bytes</source>
        <translation>Bytes</translation>
    </message>
    <message>
        <source>found %1 for %2, expected %3</source>
        <translation>gefunden: %1 für %2, erwartet: %3</translation>
    </message>
    <message>
        <source>nothing</source>
        <translation>nichts</translation>
    </message>
    <message>
        <source>text</source>
        <translation>Text</translation>
    </message>
    <message>
        <source>found no contacts of layers in the column layers</source>
        <translation>keine Kontakte von Schichten in der Spalte layers gefunden</translation>
    </message>
    <message>
        <source>%1 is hidden or not palpable</source>
        <translation>%1 ist ausgeblendet oder nicht tastbar</translation>
    </message>
    <message>
        <source>the scene has no structure &quot;%1&quot;, which it names as the organ</source>
        <translation>die Szene enthält keine Struktur „%1“, die als Organ genannt ist</translation>
    </message>
    <message>
        <source>it lies in no closed surface that can be felt</source>
        <translation>liegt in keiner geschlossenen Oberfläche, die tastbar ist</translation>
    </message>
    <message>
        <source>its name is not that of a lump, and the scene gives no stiffness ratio</source>
        <translation>der Name bezeichnet keinen Knoten, und die Szene gibt kein Steifigkeitsverhältnis an</translation>
    </message>
    <message>
        <source>the scene names the organs of other lumps, but not of this one</source>
        <translation>die Szene nennt die Organe anderer Knoten, aber nicht dieses</translation>
    </message>
    <message>
        <source>the SpaceMouse is the hand now; choose another device for it first</source>
        <translation>die SpaceMouse ist jetzt die Hand; bitte erst ein anderes Gerät dafür wählen</translation>
    </message>
    <message>
        <source>the SpaceMouse moves the view or presses; switch that off first</source>
        <translation>die SpaceMouse bewegt die Ansicht oder drückt; das zuerst ausschalten</translation>
    </message>
    <message>
        <source>no device is called &quot;%1&quot;</source>
        <translation>kein Gerät heißt „%1“</translation>
    </message>
    <message>
        <source>the simulated hand palpates what is in the middle of the view: found nothing palpable there</source>
        <translation>die simulierte Hand tastet, was in der Mitte der Ansicht ist: dort ist nichts zu fühlen</translation>
    </message>
    <message>
        <source>found no open recording, expected one whose motion the device repeats</source>
        <translation>keine Aufzeichnung ist offen, erwartet: eine, deren Bewegung das Gerät wiederholt</translation>
    </message>
    <message>
        <source>rate and CPU cannot be changed while a recording runs; stop it first</source>
        <translation>Takt und Prozessor lassen sich nicht ändern, solange eine Aufzeichnung läuft; bitte erst beenden</translation>
    </message>
    <message>
        <source>the device cannot be changed while a recording runs; stop it first</source>
        <translation>das Gerät lässt sich nicht wechseln, solange eine Aufzeichnung läuft; bitte erst beenden</translation>
    </message>
    <message>
        <source>%1 may not be opened: install Palpate&apos;s udev rule (in lib/udev/rules.d) and plug the device in anew</source>
        <translation>%1 darf nicht geöffnet werden: installieren Sie die udev-Regel von Palpate (in lib/udev/rules.d) und stecken Sie das Gerät neu ein</translation>
    </message>
    <message>
        <source>%1: could not be opened: %2</source>
        <translation>%1: konnte nicht geöffnet werden: %2</translation>
    </message>
    <message>
        <source>%1: already started</source>
        <translation>%1: schon gestartet</translation>
    </message>
    <message>
        <source>%1: %2: found %3, expected %4 to %5</source>
        <translation>%1: %2: gefunden: %3, erwartet: %4 bis %5</translation>
    </message>
    <message>
        <source>no number</source>
        <translation>keine Zahl</translation>
    </message>
    <message>
        <source>no 6-axis mouse is connected: plug one in</source>
        <translation>keine 6-Achsen-Maus ist angeschlossen: stecken Sie eine ein</translation>
    </message>
    <message>
        <source>%1: at byte %2: %3, expected an object of numbers, {&quot;length_body_a&quot;: 0.080, ...}</source>
        <translation>%1: bei Byte %2: %3, erwartet: ein Objekt mit Zahlen, {&quot;length_body_a&quot;: 0.080, ...}</translation>
    </message>
    <message>
        <source>too large for a device&apos;s configuration</source>
        <translation>zu groß für die Konfiguration eines Geräts</translation>
    </message>
    <message>
        <source>%1: could not be read</source>
        <translation>%1: konnte nicht gelesen werden</translation>
    </message>
    <message>
        <source>no WoodenHaptics arm is connected (USB 1234:0006): plug it in and switch it on</source>
        <translation>kein WoodenHaptics-Arm ist angeschlossen (USB 1234:0006): stecken Sie ihn ein und schalten Sie ihn an</translation>
    </message>
    <message>
        <source>woodenhaptics: %1: its reports have %2 bytes, expected 14 or 8: another device with mbed&apos;s ids</source>
        <translation>woodenhaptics: %1: die Meldungen haben %2 Bytes, erwartet: 14 oder 8; ein anderes Gerät mit den Kennungen von mbed</translation>
    </message>
    <message>
        <source>woodenhaptics: %1: it does not answer; is it switched on?</source>
        <translation>woodenhaptics: %1: antwortet nicht; ist der Arm angeschaltet?</translation>
    </message>
    <message>
        <source>ticks are missing</source>
        <translation>Ticks fehlen</translation>
    </message>
    <message>
        <source>contact radius: found %1 mm, expected more than 0 and at most 30 mm</source>
        <translation>Kontaktradius: gefunden %1 mm, erwartet mehr als 0 und höchstens 30 mm</translation>
    </message>
    <message>
        <source>press depths: found %1, expected 1 to %2</source>
        <translation>Eindrucktiefen: gefunden %1, erwartet 1 bis %2</translation>
    </message>
    <message>
        <source>press depths: found %1 mm, expected 0 to 30 mm, ascending</source>
        <translation>Eindrucktiefen: gefunden %1 mm, erwartet 0 bis 30 mm, aufsteigend</translation>
    </message>
    <message>
        <source>%1: contact radius: found %2 mm, expected at least %3 mm on a surface this large</source>
        <translation>%1: Kontaktradius: gefunden %2 mm, erwartet mindestens %3 mm auf einer so großen Oberfläche</translation>
    </message>
    <message>
        <source>%1: ratio: found %2, expected more than 0 and at most 10000</source>
        <translation>%1: Verhältnis: gefunden %2, erwartet mehr als 0 und höchstens 10000</translation>
    </message>
    <message>
        <source>%1: left out, its surface is open: it has no volume to be felt</source>
        <translation>%1: weggelassen: die Oberfläche ist offen, es gibt kein Volumen zu fühlen</translation>
    </message>
    <message>
        <source>%1: left out, its surface is inside out</source>
        <translation>%1: weggelassen: die Oberfläche ist umgestülpt</translation>
    </message>
    <message>
        <source>%1: left out, it lies outside %2</source>
        <translation>%1: weggelassen: liegt außerhalb von %2</translation>
    </message>
    <message>
        <source>%1 and %2 reach into each other: where both are felt is not judged</source>
        <translation>%1 und %2 reichen ineinander: wo beide zu fühlen sind, wird nicht beurteilt</translation>
    </message>
    <message>
        <source>what can be felt was cancelled</source>
        <translation>die Berechnung des Tastbaren wurde abgebrochen</translation>
    </message>
    <message>
        <source>%1: its surface is open or inside out; expected a closed one, or it can&apos;t be told what lies in it</source>
        <translation>%1: die Oberfläche ist offen oder umgestülpt; erwartet: eine geschlossene, sonst lässt sich nicht feststellen, was darin liegt</translation>
    </message>
    <message>
        <source>%1: found no lump in it that can be judged</source>
        <translation>%1: kein Knoten darin, der sich beurteilen lässt</translation>
    </message>
    <message>
        <source>%1: its triangles are wider than a finger&apos;s contact: what the hand feels of its lumps differs by up to %2 % from what is shown; a finer mesh mends it</source>
        <translation>%1: seine Dreiecke sind breiter als die Kontaktfläche eines Fingers: was die Hand von seinen Knoten fühlt, weicht um bis zu %2 % vom Gezeigten ab; ein feineres Netz behebt das</translation>
    </message>
    <message>
        <source>%1: reading was cancelled</source>
        <translation>%1: das Lesen wurde abgebrochen</translation>
    </message>
    <message>
        <source>no socket for the import server: %1</source>
        <translation>kein Socket für den Importserver: %1</translation>
    </message>
    <message>
        <source>no process for the import server: %1</source>
        <translation>kein Prozess für den Importserver: %1</translation>
    </message>
    <message>
        <source>%1: opening was cancelled</source>
        <translation>%1: das Öffnen wurde abgebrochen</translation>
    </message>
    <message>
        <source>%1: is not a Palpate scene: found neither `version` nor `structures`; expected a file that Palpate saved (.palpate.json)</source>
        <translation>%1: ist keine Szene von Palpate: weder `version` noch `structures` ist darin; erwartet: eine Datei, die Palpate gespeichert hat (.palpate.json)</translation>
    </message>
    <message>
        <source>%1: %2: found twice, expected it once</source>
        <translation>%1: %2: zweimal gefunden, erwartet: einmal</translation>
    </message>
    <message>
        <source>%1: version: found %2, expected at most %3: it was made by a newer Palpate</source>
        <translation>%1: Version: gefunden %2, erwartet höchstens %3: eine neuere Fassung von Palpate hat sie geschrieben</translation>
    </message>
    <message>
        <source>VTK could not write it: %1</source>
        <translation>VTK konnte es nicht schreiben: %1</translation>
    </message>
    <message>
        <source>%1: not felt through an organ: %2</source>
        <translation>%1: nicht durch ein Organ hindurch tastbar: %2</translation>
    </message>
    <message>
        <source>%1 seems to lie in %2, whose surface is open or inside out</source>
        <translation>%1 liegt wohl in %2, dessen Oberfläche offen oder umgestülpt ist</translation>
    </message>
    <message>
        <source>ratio of &quot;%1&quot;: found no such lump, expected a structure that lies in another one</source>
        <translation>Verhältnis von „%1“: kein solcher Knoten, erwartet: eine Struktur, die in einer anderen liegt</translation>
    </message>
    <message>
        <source>found no lump, expected a palpable structure inside another one&apos;s closed surface, or one whose `inside` names its organ</source>
        <translation>kein Knoten gefunden, erwartet: eine tastbare Struktur innerhalb der geschlossenen Oberfläche einer anderen oder eine, deren `inside` ihr Organ nennt</translation>
    </message>
    <message>
        <source>the servo thread does not answer</source>
        <translation>der Servo-Thread antwortet nicht</translation>
    </message>
    <message>
        <source>%1: found more than 64 MiB, expected a list of points</source>
        <translation>%1: mehr als 64 MiB gefunden, erwartet: eine Liste von Punkten</translation>
    </message>
    <message>
        <source>%1: byte %2: found %3, expected markups of 3D Slicer (.mrk.json)</source>
        <translation>%1: Byte %2: gefunden %3, erwartet: Markups von 3D Slicer (.mrk.json)</translation>
    </message>
    <message>
        <source>no JSON object</source>
        <translation>kein JSON-Objekt</translation>
    </message>
    <message>
        <source>%1: markups: found nothing, expected lists of points: is this a .mrk.json of 3D Slicer?</source>
        <translation>%1: markups: nichts gefunden, erwartet: Listen von Punkten: ist das eine .mrk.json von 3D Slicer?</translation>
    </message>
    <message>
        <source>the recording does not say what scene it was made on</source>
        <translation>die Aufzeichnung sagt nicht, auf welcher Szene sie gemacht wurde</translation>
    </message>
    <message>
        <source>%1: no such file</source>
        <translation>%1: die Datei ist nicht da</translation>
    </message>
    <message>
        <source>%1: not written: cancelled</source>
        <translation>%1: nicht geschrieben: abgebrochen</translation>
    </message>
    <message>
        <source>%1: not written: found no tick with a hand, expected at least one</source>
        <translation>%1: nicht geschrieben: kein Augenblick mit einer Hand darin, erwartet: mindestens einer</translation>
    </message>
    <message>
        <source>%1: not written: no surface that is there was touched</source>
        <translation>%1: nicht geschrieben: keine vorhandene Oberfläche wurde berührt</translation>
    </message>
    <message>
        <source>%1: the touched surface goes there; found another file, expected none or an older export. Choose another name</source>
        <translation>%1: dorthin kommt die berührte Oberfläche; dort liegt eine andere Datei, erwartet wurde keine oder ein älterer Export. Wählen Sie einen anderen Namen</translation>
    </message>
    <message>
        <source>%1 is a recording and keeps its own layers</source>
        <translation>%1 ist eine Aufzeichnung und behält ihre eigenen Schichten</translation>
    </message>
    <message>
        <source>%1 is a scene file and keeps its own layers</source>
        <translation>%1 ist eine Szenendatei und behält ihre eigenen Schichten</translation>
    </message>
    <message>
        <source>nothing lies in another structure: all is in one layer</source>
        <translation>nichts liegt in einer anderen Struktur: alles ist in einer Schicht</translation>
    </message>
    <message>
        <source>%1 and %2 more</source>
        <translation>%1 und %2 weitere</translation>
    </message>
    <message>
        <source>%1</source>
        <translation>%1</translation>
    </message>
    <message>
        <source>the steps of %1 are felt, with forces that are wrong by a multiple: --smooth smooths them</source>
        <translation>die Stufen von %1 sind zu fühlen, mit um ein Vielfaches falschen Kräften: --smooth glättet sie</translation>
    </message>
    <message>
        <source>1 surface is inside out and felt from within only: %1; --outwards turns closed surfaces outwards</source>
        <translation>1 Oberfläche ist umgestülpt und nur von innen zu fühlen: %1; --outwards wendet geschlossene Oberflächen nach außen</translation>
    </message>
    <message>
        <source>%1 surfaces are inside out and felt from within only: %2; --outwards turns closed surfaces outwards</source>
        <translation>%1 Oberflächen sind umgestülpt und nur von innen zu fühlen: %2; --outwards wendet geschlossene Oberflächen nach außen</translation>
    </message>
    <message>
        <source>%1: found %2, expected 0 to %3 %4</source>
        <translation>%1: %2 gefunden, erwartet 0 bis %3 %4</translation>
    </message>
    <message>
        <source>friction_dynamic: found %1, expected at most %2 (friction_static)</source>
        <translation>friction_dynamic: %1 gefunden, erwartet höchstens %2 (friction_static)</translation>
    </message>
    <message>
        <source>1 value of arrays differed by more than 10 % from another at the same vertex: the mean is used</source>
        <translation>1 Wert wich um mehr als 10 % von einem anderen am selben Eckpunkt ab: das Mittel gilt</translation>
    </message>
    <message>
        <source>%1 values of arrays differed by more than 10 % from another at the same vertex: the mean is used</source>
        <translation>%1 Werte wichen um mehr als 10 % von einem anderen am selben Eckpunkt ab: das Mittel gilt</translation>
    </message>
    <message>
        <source>1 triangle without area left out</source>
        <translation>1 Dreieck ohne Fläche weggelassen</translation>
    </message>
    <message>
        <source>%1 triangles without area left out</source>
        <translation>%1 Dreiecke ohne Fläche weggelassen</translation>
    </message>
    <message>
        <source>1 duplicate triangle left out</source>
        <translation>1 doppeltes Dreieck weggelassen</translation>
    </message>
    <message>
        <source>%1 duplicate triangles left out</source>
        <translation>%1 doppelte Dreiecke weggelassen</translation>
    </message>
    <message>
        <source>1 triangle turned round to face the same way as the rest</source>
        <translation>1 Dreieck gewendet, damit es zur selben Seite zeigt wie die übrigen</translation>
    </message>
    <message>
        <source>%1 triangles turned round to face the same way as the rest</source>
        <translation>%1 Dreiecke gewendet, damit sie zur selben Seite zeigen wie die übrigen</translation>
    </message>
    <message>
        <source>1 open edge: the surface has holes or a rim</source>
        <translation>1 offene Kante: die Oberfläche hat Löcher oder einen Rand</translation>
    </message>
    <message>
        <source>%1 open edges: the surface has holes or a rim</source>
        <translation>%1 offene Kanten: die Oberfläche hat Löcher oder einen Rand</translation>
    </message>
    <message>
        <source>1 edge shared by more than two triangles</source>
        <translation>1 Kante gehört zu mehr als zwei Dreiecken</translation>
    </message>
    <message>
        <source>%1 edges shared by more than two triangles</source>
        <translation>%1 Kanten gehören zu mehr als zwei Dreiecken</translation>
    </message>
    <message>
        <source>1 part without a consistent front</source>
        <translation>1 Teil ohne einheitliche Vorderseite</translation>
    </message>
    <message>
        <source>%1 parts without a consistent front</source>
        <translation>%1 Teile ohne einheitliche Vorderseite</translation>
    </message>
    <message>
        <source>1 part without an inside, touched from both sides</source>
        <translation>1 Teil ohne Inneres, von beiden Seiten zu fühlen</translation>
    </message>
    <message>
        <source>%1 parts without an inside, touched from both sides</source>
        <translation>%1 Teile ohne Inneres, von beiden Seiten zu fühlen</translation>
    </message>
    <message>
        <source>1 closed part looks inside out: touched from within only, unless turned outwards</source>
        <translation>1 geschlossener Teil sieht umgestülpt aus: nur von innen berührbar, solange er nicht umgedreht wird</translation>
    </message>
    <message>
        <source>%1 closed parts look inside out: touched from within only, unless turned outwards</source>
        <translation>%1 geschlossene Teile sehen umgestülpt aus: nur von innen berührbar, solange sie nicht umgedreht werden</translation>
    </message>
    <message>
        <source>1 closed part was inside out and turned to face outwards</source>
        <translation>1 geschlossener Teil war umgestülpt und wurde nach außen gewendet</translation>
    </message>
    <message>
        <source>%1 closed parts were inside out and turned to face outwards</source>
        <translation>%1 geschlossene Teile waren umgestülpt und wurden nach außen gewendet</translation>
    </message>
    <message>
        <source>surface from a label map of %1 × %2 × %3 mm voxels, with its steps</source>
        <translation>Oberfläche aus einer Labelkarte mit Voxeln von %1 × %2 × %3 mm, mit ihren Stufen</translation>
    </message>
    <message>
        <source>staircase of about %1 × %2 × %3 mm voxels (%4 % of the area in %5 directions)</source>
        <translation>Treppe aus Voxeln von etwa %1 × %2 × %3 mm (%4 % der Fläche in %5 Richtungen)</translation>
    </message>
    <message>
        <source>the mesh has no triangles, expected at least 1</source>
        <translation>das Netz hat keine Dreiecke, erwartet mindestens 1</translation>
    </message>
    <message>
        <source>the mesh has %1 vertices or triangles, expected at most %2</source>
        <translation>das Netz hat %1 Eckpunkte oder Dreiecke, erwartet höchstens %2</translation>
    </message>
    <message>
        <source>triangle %1 uses vertex %2, expected a number below %3</source>
        <translation>Dreieck %1 verwendet Eckpunkt %2, erwartet eine Nummer unter %3</translation>
    </message>
    <message>
        <source>vertex %1 has the coordinate %2, expected a finite number</source>
        <translation>Eckpunkt %1 hat die Koordinate %2, erwartet eine endliche Zahl</translation>
    </message>
    <message>
        <source>vertex %1 has the coordinate %2 mm, expected at most %3 mm; check the unit</source>
        <translation>Eckpunkt %1 hat die Koordinate %2 mm, erwartet höchstens %3 mm; prüfen Sie die Einheit</translation>
    </message>
    <message>
        <source>array %1 has %2 values, expected %3</source>
        <translation>Feld %1 hat %2 Werte, erwartet %3</translation>
    </message>
    <message>
        <source>weldWithin_mm: found %1, expected 0 to %2 mm</source>
        <translation>weldWithin_mm: %1 gefunden, erwartet 0 bis %2 mm</translation>
    </message>
    <message>
        <source>none of the %1 triangles has an area; check the unit, expected mm</source>
        <translation>keines der %1 Dreiecke hat eine Fläche; prüfen Sie die Einheit, erwartet mm</translation>
    </message>
    <message>
        <source>found structure %1, expected a number below %2</source>
        <translation>Struktur %1 gefunden, erwartet eine Nummer unter %2</translation>
    </message>
    <message>
        <source>structure %1 (%2)</source>
        <translation>Struktur %1 (%2)</translation>
    </message>
    <message>
        <source>fingertip: found a radius of %1, expected 0 to %2 mm</source>
        <translation>Fingerspitze: Radius %1 gefunden, erwartet 0 bis %2 mm</translation>
    </message>
    <message>
        <source>structure %1 (%2): found no surface, expected at least one triangle</source>
        <translation>Struktur %1 (%2): keine Oberfläche gefunden, erwartet mindestens ein Dreieck</translation>
    </message>
    <message>
        <source>found %1</source>
        <translation>gefunden %1</translation>
    </message>
    <message>
        <source>the keyword %1 or %2</source>
        <translation>das Schlüsselwort %1 oder %2</translation>
    </message>
    <message>
        <source>found %1 as corner %2 of a facet</source>
        <translation>%1 als Ecke %2 einer Facette gefunden</translation>
    </message>
    <message>
        <source>the keyword %1, three times in each facet</source>
        <translation>das Schlüsselwort %1, dreimal in jeder Facette</translation>
    </message>
    <message>
        <source>the vertex has fewer than three coordinates</source>
        <translation>der Eckpunkt hat weniger als drei Koordinaten</translation>
    </message>
    <message>
        <source>%1 is not a number</source>
        <translation>%1 ist keine Zahl</translation>
    </message>
    <message>
        <source>three numbers</source>
        <translation>drei Zahlen</translation>
    </message>
    <message>
        <source>finite coordinates within 10 km</source>
        <translation>endliche Koordinaten innerhalb von 10 km</translation>
    </message>
    <message>
        <source>found %1 after the third coordinate</source>
        <translation>%1 nach der dritten Koordinate gefunden</translation>
    </message>
    <message>
        <source>the end of the line</source>
        <translation>das Ende der Zeile</translation>
    </message>
    <message>
        <source>the keyword %1</source>
        <translation>das Schlüsselwort %1</translation>
    </message>
    <message>
        <source>found %1 after three corners</source>
        <translation>%1 nach drei Ecken gefunden</translation>
    </message>
    <message>
        <source>found a zero byte</source>
        <translation>ein Null-Byte gefunden</translation>
    </message>
    <message>
        <source>the file ends after one complete triangle</source>
        <translation>die Datei endet nach einem ganzen Dreieck</translation>
    </message>
    <message>
        <source>the file ends after %1 complete triangles</source>
        <translation>die Datei endet nach %1 ganzen Dreiecken</translation>
    </message>
    <message>
        <source>the rest of a facet, then the keyword %1</source>
        <translation>der Rest einer Facette, dann das Schlüsselwort %1</translation>
    </message>
    <message>
        <source>%1; --partial opens the complete triangles</source>
        <translation>%1; --partial öffnet die vollständigen Dreiecke</translation>
    </message>
    <message>
        <source>0 triangles</source>
        <translation>keine Dreiecke</translation>
    </message>
    <message>
        <source>at least one triangle</source>
        <translation>mindestens ein Dreieck</translation>
    </message>
    <message>
        <source>the last line, &quot;endsolid&quot;, is missing: if the file was cut off there, triangles are missing</source>
        <translation>die letzte Zeile, „endsolid“, fehlt: falls die Datei dort abgeschnitten wurde, fehlen Dreiecke</translation>
    </message>
    <message>
        <source>everything after the first triangle is lost</source>
        <translation>alles nach dem ersten Dreieck fehlt</translation>
    </message>
    <message>
        <source>everything after the first %1 triangles is lost</source>
        <translation>alles nach den ersten %1 Dreiecken fehlt</translation>
    </message>
    <message>
        <source>a cell of VTK&apos;s type %1: not a surface, but a volume mesh or curved cells</source>
        <translation>eine Zelle vom VTK-Typ %1: keine Oberfläche, sondern ein Volumennetz oder gekrümmte Zellen</translation>
    </message>
    <message>
        <source>number of corners of a cell of VTK&apos;s type %1: %2</source>
        <translation>Anzahl der Ecken einer Zelle vom VTK-Typ %1: %2</translation>
    </message>
    <message>
        <source>triangles and quadrilaterals: extract the surface first (ParaView: Extract Surface)</source>
        <translation>Dreiecke und Vierecke: zuerst die Oberfläche extrahieren (ParaView: Extract Surface)</translation>
    </message>
    <message>
        <source>vertices and lines left out: %1</source>
        <translation>weggelassene Punkte und Linien: %1</translation>
    </message>
    <message>
        <source>names and colours from the ITK-SNAP label description %1</source>
        <translation>Namen und Farben aus der ITK-SNAP-Labelbeschreibung %1</translation>
    </message>
    <message>
        <source>the file has no names: names by the numbers of %1, check them</source>
        <translation>die Datei hat keine Namen: Namen nach den Nummern von %1, bitte prüfen</translation>
    </message>
    <message>
        <source>structures of at most %1 voxels, whose shape is uncertain: %2</source>
        <translation>Strukturen von höchstens %1 Voxeln, deren Form ungewiss ist: %2</translation>
    </message>
    <message>
        <source>no voxels of %1</source>
        <translation>keine Voxel von %1</translation>
    </message>
    <message>
        <source>%1: found %2</source>
        <translation>%1: gefunden %2</translation>
    </message>
    <message>
        <source>a whole number from 0</source>
        <translation>eine ganze Zahl ab 0</translation>
    </message>
    <message>
        <source>%1: declared %2</source>
        <translation>%1: angekündigt %2</translation>
    </message>
    <message>
        <source>at most %1, one for each byte that follows</source>
        <translation>höchstens %1, je eines für jedes folgende Byte</translation>
    </message>
    <message>
        <source>the line %1</source>
        <translation>die Zeile %1</translation>
    </message>
    <message>
        <source>version %1</source>
        <translation>Version %1</translation>
    </message>
    <message>
        <source>%1 to %2</source>
        <translation>%1 bis %2</translation>
    </message>
    <message>
        <source>number of points</source>
        <translation>Anzahl der Punkte</translation>
    </message>
    <message>
        <source>points of type %1</source>
        <translation>Punkte vom Typ %1</translation>
    </message>
    <message>
        <source>a number type</source>
        <translation>ein Zahlentyp</translation>
    </message>
    <message>
        <source>a coordinate of point %1 of %2 is missing or not a number</source>
        <translation>eine Koordinate von Punkt %1 von %2 fehlt oder ist keine Zahl</translation>
    </message>
    <message>
        <source>three numbers for each point</source>
        <translation>drei Zahlen für jeden Punkt</translation>
    </message>
    <message>
        <source>point %1: %2</source>
        <translation>Punkt %1: %2</translation>
    </message>
    <message>
        <source>%1: a point index is missing or not a whole number</source>
        <translation>%1: die Nummer eines Punkts fehlt oder ist keine ganze Zahl</translation>
    </message>
    <message>
        <source>as many whole numbers as are declared</source>
        <translation>so viele ganze Zahlen, wie angekündigt sind</translation>
    </message>
    <message>
        <source>%1 use point %2</source>
        <translation>%1 verwenden den Punkt %2</translation>
    </message>
    <message>
        <source>%1 before this section</source>
        <translation>%1 vor diesem Abschnitt</translation>
    </message>
    <message>
        <source>no index, because there are no points</source>
        <translation>keine Nummer, denn es gibt keine Punkte</translation>
    </message>
    <message>
        <source>%1: number of corners of cell %2: %3</source>
        <translation>%1: Anzahl der Ecken von Zelle %2: %3</translation>
    </message>
    <message>
        <source>%1: the number of corners of cell %2 is missing</source>
        <translation>%1: die Anzahl der Ecken von Zelle %2 fehlt</translation>
    </message>
    <message>
        <source>%1 to %2, as many as the declared values allow</source>
        <translation>%1 bis %2, so viele, wie die angekündigten Werte zulassen</translation>
    </message>
    <message>
        <source>%1: number of values: declared %2</source>
        <translation>%1: Anzahl der Werte: angekündigt %2</translation>
    </message>
    <message>
        <source>%1, as many as the cells use</source>
        <translation>%1, so viele, wie die Zellen verwenden</translation>
    </message>
    <message>
        <source>found %1 and %2</source>
        <translation>gefunden %1 und %2</translation>
    </message>
    <message>
        <source>the keyword %1 and an integer type</source>
        <translation>das Schlüsselwort %1 und ein ganzzahliger Typ</translation>
    </message>
    <message>
        <source>%1: offset %2 is %3</source>
        <translation>%1: Offset %2 ist %3</translation>
    </message>
    <message>
        <source>%1: offset %2 is missing or not a whole number</source>
        <translation>%1: Offset %2 fehlt oder ist keine ganze Zahl</translation>
    </message>
    <message>
        <source>exactly %1</source>
        <translation>genau %1</translation>
    </message>
    <message>
        <source>%1: number of corners: declared %2</source>
        <translation>%1: Anzahl der Ecken: angekündigt %2</translation>
    </message>
    <message>
        <source>%1, the last offset</source>
        <translation>%1, der letzte Offset</translation>
    </message>
    <message>
        <source>number of cells</source>
        <translation>Anzahl der Zellen</translation>
    </message>
    <message>
        <source>number of values</source>
        <translation>Anzahl der Werte</translation>
    </message>
    <message>
        <source>number of cell types</source>
        <translation>Anzahl der Zelltypen</translation>
    </message>
    <message>
        <source>%1, one for each cell</source>
        <translation>%1, eine je Zelle</translation>
    </message>
    <message>
        <source>%1: a value is missing or not a whole number</source>
        <translation>%1: ein Wert fehlt oder ist keine ganze Zahl</translation>
    </message>
    <message>
        <source>length of a text: %1 bytes</source>
        <translation>Länge eines Textes: %1 Byte</translation>
    </message>
    <message>
        <source>at most %1, the number of bytes that follow</source>
        <translation>höchstens %1, die Anzahl der folgenden Bytes</translation>
    </message>
    <message>
        <source>number of arrays</source>
        <translation>Anzahl der Arrays</translation>
    </message>
    <message>
        <source>number of components</source>
        <translation>Anzahl der Komponenten</translation>
    </message>
    <message>
        <source>number of tuples</source>
        <translation>Anzahl der Tupel</translation>
    </message>
    <message>
        <source>array %1: %2</source>
        <translation>Array %1: %2</translation>
    </message>
    <message>
        <source>number of values: declared %1, of type %2</source>
        <translation>Anzahl der Werte: angekündigt %1, vom Typ %2</translation>
    </message>
    <message>
        <source>a known type and as many numbers as are declared</source>
        <translation>ein bekannter Typ und so viele Zahlen, wie angekündigt sind</translation>
    </message>
    <message>
        <source>a second section %1</source>
        <translation>ein zweiter Abschnitt %1</translation>
    </message>
    <message>
        <source>each section once</source>
        <translation>jeder Abschnitt einmal</translation>
    </message>
    <message>
        <source>a VTK file of type %1</source>
        <translation>eine VTK-Datei vom Typ %1</translation>
    </message>
    <message>
        <source>the type %1</source>
        <translation>der Typ %1</translation>
    </message>
    <message>
        <source>one of the keywords %1</source>
        <translation>eines der Schlüsselwörter %1</translation>
    </message>
    <message>
        <source>colours not read: those of %1</source>
        <translation>Farben nicht gelesen: die von %1</translation>
    </message>
    <message>
        <source>a ZIP archive</source>
        <translation>ein ZIP-Archiv</translation>
    </message>
    <message>
        <source>a PNG image</source>
        <translation>ein PNG-Bild</translation>
    </message>
    <message>
        <source>a PDF document</source>
        <translation>ein PDF-Dokument</translation>
    </message>
    <message>
        <source>an SQLite database (a recording?)</source>
        <translation>eine SQLite-Datenbank (eine Aufzeichnung?)</translation>
    </message>
    <message>
        <source>a mesh in one of the formats %1</source>
        <translation>eine Oberfläche in einem der Formate %1</translation>
    </message>
    <message>
        <source>the file is empty</source>
        <translation>die Datei ist leer</translation>
    </message>
    <message>
        <source>a web page (HTML), perhaps a failed download</source>
        <translation>eine Webseite (HTML), vielleicht ein misslungener Download</translation>
    </message>
    <message>
        <source>a Git LFS pointer, not the file itself (fetch it with `git lfs pull`)</source>
        <translation>ein Zeiger von Git LFS, nicht die Datei selbst (sie lässt sich mit `git lfs pull` holen)</translation>
    </message>
    <message>
        <source>is %1, which Palpate does not read</source>
        <translation>ist %1; das liest Palpate nicht</translation>
    </message>
    <message>
        <source>a mesh saved in one of the formats %1</source>
        <translation>eine Oberfläche, gespeichert in einem der Formate %1</translation>
    </message>
    <message>
        <source>the content is no known mesh format</source>
        <translation>der Inhalt ist kein bekanntes Format einer Oberfläche</translation>
    </message>
    <message>
        <source>three numbers after %1</source>
        <translation>drei Zahlen nach %1</translation>
    </message>
    <message>
        <source>%1 is not a vertex index</source>
        <translation>%1 ist keine Nummer eines Eckpunkts</translation>
    </message>
    <message>
        <source>whole numbers after %1</source>
        <translation>ganze Zahlen nach %1</translation>
    </message>
    <message>
        <source>vertex index %1 (number of vertices so far: %2)</source>
        <translation>die Eckpunktnummer %1 (Anzahl der Eckpunkte bis hier: %2)</translation>
    </message>
    <message>
        <source>indices from 1, or negative indices that count back from the last vertex</source>
        <translation>Nummern ab 1 oder negative Nummern, die vom letzten Eckpunkt zurückzählen</translation>
    </message>
    <message>
        <source>a face with one corner</source>
        <translation>eine Fläche mit einer Ecke</translation>
    </message>
    <message>
        <source>a face with %1 corners</source>
        <translation>eine Fläche mit %1 Ecken</translation>
    </message>
    <message>
        <source>at least %1</source>
        <translation>mindestens %1</translation>
    </message>
    <message>
        <source>at most %1</source>
        <translation>höchstens %1</translation>
    </message>
    <message>
        <source>vertex index %1</source>
        <translation>die Eckpunktnummer %1</translation>
    </message>
    <message>
        <source>at most %1, the number of vertices</source>
        <translation>höchstens %1, die Anzahl der Eckpunkte</translation>
    </message>
    <message>
        <source>colours not read: those of its material</source>
        <translation>Farben nicht gelesen: die des Materials</translation>
    </message>
    <message>
        <source>colours not read: those of its %1 materials</source>
        <translation>Farben nicht gelesen: die der %1 Materialien</translation>
    </message>
    <message>
        <source>number of line, point and curve elements that are ignored: %1</source>
        <translation>Anzahl der nicht beachteten Linien-, Punkt- und Kurvenelemente: %1</translation>
    </message>
    <message>
        <source>colours not read: those of its vertices</source>
        <translation>Farben nicht gelesen: die der Eckpunkte</translation>
    </message>
    <message>
        <source>the file ends in a line; that line is lost</source>
        <translation>die Datei endet mitten in einer Zeile; diese Zeile fehlt</translation>
    </message>
    <message>
        <source>a mesh saved as STL, PLY, OBJ or VTK (MeshLab or Blender convert it)</source>
        <translation>ein als STL, PLY, OBJ oder VTK gespeichertes Netz (MeshLab oder Blender wandeln es um)</translation>
    </message>
    <message>
        <source>a mesh in VTK format: convert it with FreeSurfer&apos;s mris_convert to a name that ends in .vtk</source>
        <translation>ein Netz im VTK-Format: mit mris_convert von FreeSurfer in eine Datei mit der Endung .vtk umwandeln</translation>
    </message>
    <message>
        <source>an AppleDouble file, in which macOS keeps the attributes of another file</source>
        <translation>eine AppleDouble-Datei, in der macOS die Attribute einer anderen Datei ablegt</translation>
    </message>
    <message>
        <source>the file of the same name without &quot;._&quot;</source>
        <translation>die Datei desselben Namens ohne „._“</translation>
    </message>
    <message>
        <source>a glTF file</source>
        <translation>eine glTF-Datei</translation>
    </message>
    <message>
        <source>an FBX file</source>
        <translation>eine FBX-Datei</translation>
    </message>
    <message>
        <source>a Blender file</source>
        <translation>eine Blender-Datei</translation>
    </message>
    <message>
        <source>a mesh exported from Blender as STL, PLY or OBJ</source>
        <translation>ein aus Blender als STL, PLY oder OBJ exportiertes Netz</translation>
    </message>
    <message>
        <source>a Gmsh mesh</source>
        <translation>ein Gmsh-Netz</translation>
    </message>
    <message>
        <source>its surface saved as VTK or STL (Gmsh: Export)</source>
        <translation>seine Oberfläche, als VTK oder STL gespeichert (Gmsh: Export)</translation>
    </message>
    <message>
        <source>a VRML file</source>
        <translation>eine VRML-Datei</translation>
    </message>
    <message>
        <source>a STEP model</source>
        <translation>ein STEP-Modell</translation>
    </message>
    <message>
        <source>a mesh made of it (FreeCAD: Export as STL)</source>
        <translation>ein daraus erzeugtes Netz (FreeCAD: als STL exportieren)</translation>
    </message>
    <message>
        <source>a 3D Slicer scene (MRML)</source>
        <translation>eine Szene von 3D Slicer (MRML)</translation>
    </message>
    <message>
        <source>an AMF file</source>
        <translation>eine AMF-Datei</translation>
    </message>
    <message>
        <source>a COLLADA file</source>
        <translation>eine COLLADA-Datei</translation>
    </message>
    <message>
        <source>an X3D file</source>
        <translation>eine X3D-Datei</translation>
    </message>
    <message>
        <source>a JSON document</source>
        <translation>ein JSON-Dokument</translation>
    </message>
    <message>
        <source>a mesh, or a scene of Palpate with a name that ends in .json</source>
        <translation>ein Netz oder eine Szene von Palpate, deren Name auf .json endet</translation>
    </message>
    <message>
        <source>%1 is not a number, in element %2 %3 of %4</source>
        <translation>%1 ist keine Zahl, im Element %2 %3 von %4</translation>
    </message>
    <message>
        <source>the file ends in element %1 %2 of %3</source>
        <translation>die Datei endet im Element %1 %2 von %3</translation>
    </message>
    <message>
        <source>vertex %1: %2</source>
        <translation>Eckpunkt %1: %2</translation>
    </message>
    <message>
        <source>number of corners of face %1: %2</source>
        <translation>Anzahl der Ecken von Fläche %1: %2</translation>
    </message>
    <message>
        <source>face %1 uses vertex %2</source>
        <translation>die Fläche %1 verwendet den Eckpunkt %2</translation>
    </message>
    <message>
        <source>the property %1</source>
        <translation>die Eigenschaft %1</translation>
    </message>
    <message>
        <source>element %1 %2: length of a list: %3</source>
        <translation>Element %1 %2: Länge einer Liste: %3</translation>
    </message>
    <message>
        <source>header</source>
        <translation>Kopf</translation>
    </message>
    <message>
        <source>no faces with a list of vertex indices</source>
        <translation>keine Flächen mit einer Liste von Eckpunkten</translation>
    </message>
    <message>
        <source>found the element %1</source>
        <translation>das Element %1 gefunden</translation>
    </message>
    <message>
        <source>%1, then %2, once each</source>
        <translation>%1, dann %2, je einmal</translation>
    </message>
    <message>
        <source>no vertices with x, y and z</source>
        <translation>keine Eckpunkte mit x, y und z</translation>
    </message>
    <message>
        <source>one of each</source>
        <translation>je eines davon</translation>
    </message>
    <message>
        <source>number of vertices: %1, of faces: %2</source>
        <translation>Anzahl der Eckpunkte: %1, der Flächen: %2</translation>
    </message>
    <message>
        <source>at most %1 of each</source>
        <translation>jeweils höchstens %1</translation>
    </message>
    <message>
        <source>more data after the last element</source>
        <translation>weitere Daten nach dem letzten Element</translation>
    </message>
    <message>
        <source>the end of the file</source>
        <translation>das Ende der Datei</translation>
    </message>
    <message>
        <source>0 faces</source>
        <translation>keine Flächen</translation>
    </message>
    <message>
        <source>at least one face</source>
        <translation>mindestens eine Fläche</translation>
    </message>
    <message>
        <source>lines with more numbers than the header declares: %1; the surplus is left out</source>
        <translation>Zeilen mit mehr Zahlen, als der Kopf angibt: %1; das Überzählige ist weggelassen</translation>
    </message>
    <message>
        <source>the file ends there: %1 of %2 faces lost</source>
        <translation>die Datei endet dort: %1 von %2 Flächen fehlen</translation>
    </message>
    <message>
        <source>the format %1</source>
        <translation>das Format %1</translation>
    </message>
    <message>
        <source>%1, %2 or %3</source>
        <translation>%1, %2 oder %3</translation>
    </message>
    <message>
        <source>the element count %1</source>
        <translation>die Anzahl der Elemente %1</translation>
    </message>
    <message>
        <source>a type and a name, below an element</source>
        <translation>ein Typ und ein Name, unter einem Element</translation>
    </message>
    <message>
        <source>lines of the header that are none of PLY left out: %1</source>
        <translation>weggelassene Kopfzeilen, die nicht zu PLY gehören: %1</translation>
    </message>
    <message>
        <source>the header has no line %1</source>
        <translation>im Kopf fehlt die Zeile %1</translation>
    </message>
    <message>
        <source>one such line</source>
        <translation>eine solche Zeile</translation>
    </message>
    <message>
        <source>the file ends in the header</source>
        <translation>die Datei endet in ihrem Kopf</translation>
    </message>
    <message>
        <source>colours not read: those of its elements %1</source>
        <translation>Farben nicht gelesen: die der Elemente %1</translation>
    </message>
    <message>
        <source>number of elements %1: declared %2</source>
        <translation>Anzahl der Elemente %1: angekündigt %2</translation>
    </message>
    <message>
        <source>at most %1, as many as the %2 bytes that follow can hold</source>
        <translation>höchstens %1, so viele, wie in die folgenden %2 Byte passen</translation>
    </message>
    <message>
        <source>coordinates are not numbers in %1 of %2 triangles (first: triangle %3)</source>
        <translation>Koordinaten sind keine Zahlen in %1 von %2 Dreiecken (als erstes Dreieck %3)</translation>
    </message>
    <message>
        <source>coordinates are farther than 10 km from the origin in %1 of %2 triangles (first: triangle %3)</source>
        <translation>Koordinaten sind weiter als 10 km vom Ursprung entfernt in %1 von %2 Dreiecken (als erstes Dreieck %3)</translation>
    </message>
    <message>
        <source>coordinates are not numbers, or farther than 10 km from the origin, in %1 of %2 triangles (first: triangle %3)</source>
        <translation>Koordinaten sind keine Zahlen oder weiter als 10 km vom Ursprung entfernt in %1 von %2 Dreiecken (als erstes Dreieck %3)</translation>
    </message>
    <message>
        <source>the last triangle is whole, but the attribute behind it is cut off</source>
        <translation>das letzte Dreieck ist vollständig, aber das Attribut dahinter ist abgeschnitten</translation>
    </message>
    <message>
        <source>the file ends there: %1 of %2 triangles lost</source>
        <translation>die Datei endet dort: %1 von %2 Dreiecken fehlen</translation>
    </message>
    <message>
        <source>cut off: the binary STL declares %1 triangles, but the %2 bytes hold %3</source>
        <translation>abgeschnitten: das binäre STL nennt %1 Dreiecke, aber die %2 Bytes enthalten %3</translation>
    </message>
    <message>
        <source>%1 bytes</source>
        <translation>%1 Byte</translation>
    </message>
    <message>
        <source>%1 bytes; --partial opens the first %2 of %3 triangles</source>
        <translation>%1 Bytes; --partial öffnet die ersten %2 von %3 Dreiecken</translation>
    </message>
    <message>
        <source>number of triangles of the binary STL: declared %1, but the %2 bytes hold %3</source>
        <translation>Anzahl der Dreiecke der binären STL-Datei: angekündigt %1, aber in den %2 Byte sind %3</translation>
    </message>
    <message>
        <source>colours not read: those of %1 of the triangles, as a structure has one colour</source>
        <translation>Farben nicht gelesen: die von %1 der Dreiecke, denn eine Struktur hat eine Farbe</translation>
    </message>
    <message>
        <source>the file ends in the STL header</source>
        <translation>die Datei endet im Kopf der STL-Datei</translation>
    </message>
    <message>
        <source>at least %1 bytes</source>
        <translation>mindestens %1 Byte</translation>
    </message>
    <message>
        <source>a number in the range of %1</source>
        <translation>eine Zahl im Bereich von %1</translation>
    </message>
    <message>
        <source>a blank or a line end after it</source>
        <translation>ein Leerzeichen oder ein Zeilenende dahinter</translation>
    </message>
    <message>
        <source>its type is %1</source>
        <translation>sein Typ ist %1</translation>
    </message>
    <message>
        <source>size of its data: %1 bytes</source>
        <translation>Größe seiner Daten: %1 Byte</translation>
    </message>
    <message>
        <source>a multiple of %1 bytes</source>
        <translation>ein Vielfaches von %1 Byte</translation>
    </message>
    <message>
        <source>value %1 is %2</source>
        <translation>Wert %1 ist %2</translation>
    </message>
    <message>
        <source>a number of type %1</source>
        <translation>eine Zahl vom Typ %1</translation>
    </message>
    <message>
        <source>number of values: %1</source>
        <translation>Anzahl der Werte: %1</translation>
    </message>
    <message>
        <source>number of points: declared %1, but there is no array of points</source>
        <translation>Anzahl der Punkte: angekündigt %1, aber es gibt kein Array mit Punkten</translation>
    </message>
    <message>
        <source>an array of points</source>
        <translation>ein Array mit Punkten</translation>
    </message>
    <message>
        <source>number of components: %1</source>
        <translation>Anzahl der Komponenten: %1</translation>
    </message>
    <message>
        <source>its compressed data are damaged</source>
        <translation>seine komprimierten Daten sind beschädigt</translation>
    </message>
    <message>
        <source>data that can be decompressed</source>
        <translation>Daten, die sich dekomprimieren lassen</translation>
    </message>
    <message>
        <source>%1: declared %2 cells, but an array is missing</source>
        <translation>%1: %2 Zellen sind angekündigt, aber ein Array fehlt</translation>
    </message>
    <message>
        <source>the arrays %1 and %2</source>
        <translation>die Arrays %1 und %2</translation>
    </message>
    <message>
        <source>its type is %1, its number of components %2</source>
        <translation>sein Typ ist %1, seine Anzahl von Komponenten %2</translation>
    </message>
    <message>
        <source>whole numbers with one component</source>
        <translation>ganze Zahlen mit einer Komponente</translation>
    </message>
    <message>
        <source>value %1 is point %2</source>
        <translation>Wert %1 ist der Punkt %2</translation>
    </message>
    <message>
        <source>character %1 is %2</source>
        <translation>Zeichen %1 ist %2</translation>
    </message>
    <message>
        <source>a number from %1 to %2</source>
        <translation>eine Zahl von %1 bis %2</translation>
    </message>
    <message>
        <source>its last string has no end</source>
        <translation>seine letzte Zeichenkette hat kein Ende</translation>
    </message>
    <message>
        <source>a zero after each string</source>
        <translation>eine Null nach jeder Zeichenkette</translation>
    </message>
    <message>
        <source>number of tuples: declared %1, of components in each: %2</source>
        <translation>Anzahl der Tupel: angekündigt %1, der Komponenten in jedem: %2</translation>
    </message>
    <message>
        <source>exactly %1 values, as many as it contains</source>
        <translation>genau %1 Werte, so viele, wie darin sind</translation>
    </message>
    <message>
        <source>at most %1 values, as many as it contains</source>
        <translation>höchstens %1 Werte, so viele, wie darin sind</translation>
    </message>
    <message>
        <source>colours not read: the array %1 of its points</source>
        <translation>Farben nicht gelesen: das Array %1 der Punkte</translation>
    </message>
    <message>
        <source>colours not read: the array %1 of its polygons</source>
        <translation>Farben nicht gelesen: das Array %1 der Vielecke</translation>
    </message>
    <message>
        <source>%1, one for each point</source>
        <translation>%1, einer für jeden Punkt</translation>
    </message>
    <message>
        <source>%1, one for each polygon</source>
        <translation>%1, einer für jedes Vieleck</translation>
    </message>
    <message>
        <source>the array %1 is damaged and not used</source>
        <translation>das Array %1 ist beschädigt und wird nicht verwendet</translation>
    </message>
    <message>
        <source>number of elements: declared %1</source>
        <translation>Anzahl der Elemente: angekündigt %1</translation>
    </message>
    <message>
        <source>number of points: %1, of polygons and strips: %2</source>
        <translation>Anzahl der Punkte: %1, der Vielecke und Streifen: %2</translation>
    </message>
    <message>
        <source>the cells have no types</source>
        <translation>die Zellen haben keine Typen</translation>
    </message>
    <message>
        <source>the array %1</source>
        <translation>das Feld %1</translation>
    </message>
    <message>
        <source>number of points: %1</source>
        <translation>Anzahl der Punkte: %1</translation>
    </message>
    <message>
        <source>the file ends in the header of its data</source>
        <translation>die Datei endet im Kopf seiner Daten</translation>
    </message>
    <message>
        <source>size of its data: declared %1 bytes</source>
        <translation>Größe seiner Daten: angekündigt %1 Byte</translation>
    </message>
    <message>
        <source>at most %1, the number of characters that follow</source>
        <translation>höchstens %1, die Anzahl der folgenden Zeichen</translation>
    </message>
    <message>
        <source>block %1 reaches beyond the end of the file; its size is %2 bytes</source>
        <translation>Block %1 reicht über das Ende der Datei hinaus; seine Größe ist %2 Byte</translation>
    </message>
    <message>
        <source>at most %1 bytes</source>
        <translation>höchstens %1 Byte</translation>
    </message>
    <message>
        <source>block %1: declared sizes are %2 bytes compressed and %3 bytes decompressed</source>
        <translation>Block %1: angekündigt sind %2 Byte komprimiert und %3 Byte dekomprimiert</translation>
    </message>
    <message>
        <source>at most %1 bytes decompressed</source>
        <translation>höchstens %1 Byte dekomprimiert</translation>
    </message>
    <message>
        <source>number of blocks: declared %1</source>
        <translation>Anzahl der Blöcke: angekündigt %1</translation>
    </message>
    <message>
        <source>at most %1, the number of header words that follow</source>
        <translation>höchstens %1, die Anzahl der folgenden Wörter des Kopfs</translation>
    </message>
    <message>
        <source>block size %1 bytes, size of the last block %2 bytes</source>
        <translation>Blockgröße %1 Byte, Größe des letzten Blocks %2 Byte</translation>
    </message>
    <message>
        <source>a block size of at least one byte and a last block that is not larger</source>
        <translation>eine Blockgröße von mindestens einem Byte und ein letzter Block, der nicht größer ist</translation>
    </message>
    <message>
        <source>its data begin at offset %1</source>
        <translation>seine Daten beginnen bei Offset %1</translation>
    </message>
    <message>
        <source>less than %1, the length of the appended data</source>
        <translation>weniger als %1, die Länge der angehängten Daten</translation>
    </message>
    <message>
        <source>found %1=%2</source>
        <translation>gefunden %1=%2</translation>
    </message>
    <message>
        <source>%1 or %2</source>
        <translation>%1 oder %2</translation>
    </message>
    <message>
        <source>the compressor %1</source>
        <translation>das Kompressionsverfahren %1</translation>
    </message>
    <message>
        <source>found an array %1 under %2</source>
        <translation>ein Array %1 unter %2 gefunden</translation>
    </message>
    <message>
        <source>one array of points, one array %1 and one array %2</source>
        <translation>ein Array mit Punkten, ein Array %1 und ein Array %2</translation>
    </message>
    <message>
        <source>found an element %1 under %2</source>
        <translation>ein Element %1 unter %2 gefunden</translation>
    </message>
    <message>
        <source>an XML document of type %1</source>
        <translation>ein XML-Dokument vom Typ %1</translation>
    </message>
    <message>
        <source>found a document type or an entity</source>
        <translation>ein Dokumenttyp oder eine Entität gefunden</translation>
    </message>
    <message>
        <source>elements nested in more than %1 levels</source>
        <translation>Elemente in mehr als %1 Ebenen verschachtelt</translation>
    </message>
    <message>
        <source>at most %1 levels</source>
        <translation>höchstens %1 Ebenen</translation>
    </message>
    <message>
        <source>invalid XML: %1</source>
        <translation>ungültiges XML: %1</translation>
    </message>
    <message>
        <source>well-formed XML to the end of the file</source>
        <translation>fehlerfreies XML bis zum Ende der Datei</translation>
    </message>
    <message>
        <source>the appended data do not begin with %1</source>
        <translation>die angehängten Daten beginnen nicht mit %1</translation>
    </message>
    <message>
        <source>%1 and the data</source>
        <translation>%1 und die Daten</translation>
    </message>
    <message>
        <source>more than 2 GiB of XML</source>
        <translation>mehr als 2 GiB XML</translation>
    </message>
    <message>
        <source>arrays as appended data</source>
        <translation>Arrays als angehängte Daten</translation>
    </message>
    <message>
        <source>no element %1</source>
        <translation>kein Element %1</translation>
    </message>
    <message>
        <source>at least one such element</source>
        <translation>mindestens ein solches Element</translation>
    </message>
    <message>
        <source>not enough memory to read it: %1</source>
        <translation>nicht genug Speicher, um sie zu lesen: %1</translation>
    </message>
    <message>
        <source>cannot be read: %1</source>
        <translation>kann nicht gelesen werden: %1</translation>
    </message>
    <message>
        <source>the file became shorter while it was read</source>
        <translation>die Datei wurde kürzer, während sie gelesen wurde</translation>
    </message>
    <message>
        <source>a readable file</source>
        <translation>eine lesbare Datei</translation>
    </message>
    <message>
        <source>cannot be opened: %1</source>
        <translation>kann nicht geöffnet werden: %1</translation>
    </message>
    <message>
        <source>is a folder</source>
        <translation>ist ein Ordner</translation>
    </message>
    <message>
        <source>is not a regular file</source>
        <translation>ist keine gewöhnliche Datei</translation>
    </message>
    <message>
        <source>a mesh file</source>
        <translation>eine Datei mit einer Oberfläche</translation>
    </message>
    <message>
        <source>the frame SPACE=%1 is not used: expected LPS or RAS</source>
        <translation>das Achsensystem SPACE=%1 wird nicht verwendet; erwartet: LPS oder RAS</translation>
    </message>
    <message>
        <source>SCALE=%1 in the header is not used: expected %2 to %3</source>
        <translation>SCALE=%1 im Kopf wird nicht verwendet; erwartet: %2 bis %3</translation>
    </message>
    <message>
        <source>1 vertex without finite coordinates left out: no face uses it</source>
        <translation>1 Eckpunkt ohne endliche Koordinaten weggelassen: keine Fläche benutzt ihn</translation>
    </message>
    <message>
        <source>%1 vertices without finite coordinates left out: no face uses them</source>
        <translation>%1 Eckpunkte ohne endliche Koordinaten weggelassen: keine Fläche benutzt sie</translation>
    </message>
    <message>
        <source>1 face of fewer than 3 corners left out</source>
        <translation>1 Fläche mit weniger als 3 Ecken weggelassen</translation>
    </message>
    <message>
        <source>%1 faces of fewer than 3 corners left out</source>
        <translation>%1 Flächen mit weniger als 3 Ecken weggelassen</translation>
    </message>
    <message>
        <source>1 hidden cell left out</source>
        <translation>1 ausgeblendete Zelle weggelassen</translation>
    </message>
    <message>
        <source>%1 hidden cells left out</source>
        <translation>%1 ausgeblendete Zellen weggelassen</translation>
    </message>
    <message>
        <source>1 byte behind the last face left out</source>
        <translation>1 Byte hinter der letzten Fläche weggelassen</translation>
    </message>
    <message>
        <source>%1 bytes behind the last face left out</source>
        <translation>%1 Bytes hinter der letzten Fläche weggelassen</translation>
    </message>
    <message>
        <source>0 faces, but %1 points: a point cloud</source>
        <translation>0 Flächen, aber %1 Punkte: eine Punktwolke</translation>
    </message>
    <message>
        <source>a surface: reconstruct one first (MeshLab: Screened Poisson)</source>
        <translation>eine Oberfläche: zuerst eine rekonstruieren (MeshLab: Screened Poisson)</translation>
    </message>
    <message>
        <source>a coordinate is not a finite number (%1)</source>
        <translation>eine Koordinate ist keine endliche Zahl (%1)</translation>
    </message>
    <message>
        <source>a coordinate is farther than 10 km from the origin (%1)</source>
        <translation>eine Koordinate ist weiter als 10 km vom Ursprung entfernt (%1)</translation>
    </message>
    <message>
        <source>header: %1</source>
        <translation>Kopf: %1</translation>
    </message>
    <message>
        <source>no file %1</source>
        <translation>keine Datei %1</translation>
    </message>
    <message>
        <source>each field once</source>
        <translation>jedes Feld einmal</translation>
    </message>
    <message>
        <source>one of the two</source>
        <translation>eines von beiden</translation>
    </message>
    <message>
        <source>%1 axes</source>
        <translation>%1 Achsen</translation>
    </message>
    <message>
        <source>%1 voxels along axis %2</source>
        <translation>%1 Voxel entlang der Achse %2</translation>
    </message>
    <message>
        <source>the XML is broken: %1</source>
        <translation>das XML ist fehlerhaft: %1</translation>
    </message>
    <message>
        <source>a %1 volume with more than %2 intensities, not labels</source>
        <translation>ein %1-Volumen mit mehr als %2 Intensitäten, keine Labels</translation>
    </message>
    <message>
        <source>a %1 volume with %2 intensities, not labels</source>
        <translation>ein %1-Volumen mit %2 Intensitäten, keine Labels</translation>
    </message>
    <message>
        <source>a label map with %1 labels</source>
        <translation>eine Labelkarte mit %1 Labels</translation>
    </message>
    <message>
        <source>at most %1 labels</source>
        <translation>höchstens %1 Labels</translation>
    </message>
    <message>
        <source>a %1 volume without labels: every voxel is 0</source>
        <translation>ein %1-Volumen ohne Labels: jedes Voxel ist 0</translation>
    </message>
    <message>
        <source>at least one voxel with a label</source>
        <translation>mindestens ein Voxel mit einem Label</translation>
    </message>
    <message>
        <source>a file that can be read</source>
        <translation>eine lesbare Datei</translation>
    </message>
    <message>
        <source>content in proportion to the size of the file</source>
        <translation>Inhalt, der zur Größe der Datei passt</translation>
    </message>
    <message>
        <source>the process to read it could not be started</source>
        <translation>der Prozess, der sie lesen sollte, ließ sich nicht starten</translation>
    </message>
    <message>
        <source>room for one more process with some open files and memory (`ulimit -a` lists the limits)</source>
        <translation>Platz für einen weiteren Prozess mit einigen offenen Dateien und Speicher (`ulimit -a` listet die Grenzen auf)</translation>
    </message>
    <message>
        <source>reading it took more than %1 s of processor time</source>
        <translation>sie zu lesen brauchte mehr als %1 s Rechenzeit</translation>
    </message>
    <message>
        <source>a file that can be read in this time</source>
        <translation>eine Datei, die sich in dieser Zeit lesen lässt</translation>
    </message>
    <message>
        <source>its content is larger than %1 MiB</source>
        <translation>der Inhalt ist größer als %1 MiB</translation>
    </message>
    <message>
        <source>the system ended the process that read it, perhaps because memory ran out</source>
        <translation>das System beendete den Prozess, der sie las, vielleicht aus Mangel an Speicher</translation>
    </message>
    <message>
        <source>a smaller file, or more free memory</source>
        <translation>eine kleinere Datei oder mehr freier Speicher</translation>
    </message>
    <message>
        <source>the process that read it crashed (%1)</source>
        <translation>der Prozess, der sie las, ist abgestürzt (%1)</translation>
    </message>
    <message>
        <source>the process to read it could not limit its memory and time</source>
        <translation>der Prozess, der sie lesen sollte, konnte seinen Speicher und seine Zeit nicht begrenzen</translation>
    </message>
    <message>
        <source>limits of this program above its own limits (`ulimit -a` lists them)</source>
        <translation>Grenzen dieses Programms, die über den eigenen des Prozesses liegen (`ulimit -a` listet sie auf)</translation>
    </message>
    <message>
        <source>the process that read it could not write the result</source>
        <translation>der Prozess, der sie las, konnte das Ergebnis nicht schreiben</translation>
    </message>
    <message>
        <source>enough memory and no lower limit on the size of files (`ulimit -v`, `ulimit -f`)</source>
        <translation>genug Speicher und keine kleinere Grenze für die Größe von Dateien (`ulimit -v`, `ulimit -f`)</translation>
    </message>
    <message>
        <source>the process that read it ended with exit code %1</source>
        <translation>der Prozess, der sie las, endete mit dem Rückgabewert %1</translation>
    </message>
    <message>
        <source>the process to read it could not be started: %1</source>
        <translation>der Prozess, der sie lesen sollte, ließ sich nicht starten: %1</translation>
    </message>
    <message>
        <source>reading it took more than %1 s</source>
        <translation>sie zu lesen brauchte mehr als %1 s</translation>
    </message>
    <message>
        <source>reading it takes more than %1 MiB of memory</source>
        <translation>sie zu lesen braucht mehr als %1 MiB Speicher</translation>
    </message>
    <message>
        <source>a coordinate is not finite or is farther than 10 km from the origin</source>
        <translation>eine Koordinate ist nicht endlich oder weiter als 10 km vom Ursprung entfernt</translation>
    </message>
    <message>
        <source>a vertex index is out of range</source>
        <translation>die Nummer eines Eckpunkts liegt außerhalb ihres Bereichs</translation>
    </message>
    <message>
        <source>an array is incomplete</source>
        <translation>ein Array ist unvollständig</translation>
    </message>
    <message>
        <source>its frame is unknown</source>
        <translation>sein Achsensystem ist unbekannt</translation>
    </message>
    <message>
        <source>its unit is not positive and finite</source>
        <translation>seine Einheit ist nicht positiv und endlich</translation>
    </message>
    <message>
        <source>its voxels have no size or no axes</source>
        <translation>seine Voxel haben keine Größe oder keine Achsen</translation>
    </message>
    <message>
        <source>a colour is out of range</source>
        <translation>eine Farbe liegt außerhalb ihres Bereichs</translation>
    </message>
    <message>
        <source>a count is out of range</source>
        <translation>eine Anzahl liegt außerhalb ihres Bereichs</translation>
    </message>
    <message>
        <source>its counts do not match its size</source>
        <translation>seine Anzahlen passen nicht zu seiner Größe</translation>
    </message>
    <message>
        <source>SCALE=%1 in the header: a unit of the file is taken as %2 mm</source>
        <translation>SCALE=%1 im Kopf: eine Einheit der Datei gilt als %2 mm</translation>
    </message>
    <message>
        <source>SCALE=%1 in the header: not used, because the unit was given</source>
        <translation>SCALE=%1 im Kopf: nicht verwendet, weil die Einheit angegeben war</translation>
    </message>
    <message>
        <source>unit</source>
        <translation>Einheit</translation>
    </message>
    <message>
        <source>a positive number of millimetres per unit of the file</source>
        <translation>eine positive Anzahl von Millimetern je Einheit der Datei</translation>
    </message>
    <message>
        <source>not enough memory to read it</source>
        <translation>nicht genug Speicher, um sie zu lesen</translation>
    </message>
    <message>
        <source>polygon %1</source>
        <translation>Vieleck %1</translation>
    </message>
    <message>
        <source>number of corners: %1</source>
        <translation>Anzahl der Ecken: %1</translation>
    </message>
    <message>
        <source>it uses point %1</source>
        <translation>es verwendet den Punkt %1</translation>
    </message>
    <message>
        <source>at most %1 arrays of the points are used; number of arrays left out: %2</source>
        <translation>höchstens %1 Arrays der Punkte werden verwendet; Anzahl der weggelassenen Arrays: %2</translation>
    </message>
    <message>
        <source>at most %1 arrays of the polygons are used; number of arrays left out: %2</source>
        <translation>höchstens %1 Arrays der Vielecke werden verwendet; Anzahl der weggelassenen Arrays: %2</translation>
    </message>
    <message>
        <source>one polygon has no simple outline</source>
        <translation>ein Vieleck hat keinen einfachen Umriss</translation>
    </message>
    <message>
        <source>%1 polygons have no simple outline</source>
        <translation>%1 Vielecke haben keinen einfachen Umriss</translation>
    </message>
    <message>
        <source>%1 components per voxel</source>
        <translation>%1 Komponenten je Voxel</translation>
    </message>
    <message>
        <source>one number for each voxel</source>
        <translation>eine Zahl für jedes Voxel</translation>
    </message>
    <message>
        <source>%1 voxels declared</source>
        <translation>%1 Voxel sind angekündigt</translation>
    </message>
    <message>
        <source>as many as its %1 bytes can hold</source>
        <translation>so viele, wie in seine %1 Bytes passen</translation>
    </message>
    <message>
        <source>%1 bytes when unpacked</source>
        <translation>%1 Bytes, wenn sie entpackt sind</translation>
    </message>
    <message>
        <source>%1 bytes of voxels</source>
        <translation>%1 Bytes an Voxeln</translation>
    </message>
    <message>
        <source>a volume: .vti, .mha, .mhd, .nrrd, .nhdr, .nii or .nii.gz</source>
        <translation>ein Volumen: .vti, .mha, .mhd, .nrrd, .nhdr, .nii oder .nii.gz</translation>
    </message>
    <message>
        <source>no numbers</source>
        <translation>keine Zahlen</translation>
    </message>
    <message>
        <source>%1 numbers for %2 voxels</source>
        <translation>%1 Zahlen für %2 Voxel</translation>
    </message>
    <message>
        <source>VTK could not read it: %1</source>
        <translation>VTK konnte es nicht lesen: %1</translation>
    </message>
    <message>
        <source>no such file</source>
        <translation>die Datei ist nicht da</translation>
    </message>
    <message>
        <source>a volume</source>
        <translation>ein Volumen</translation>
    </message>
    <message>
        <source>a smaller volume, or more free memory</source>
        <translation>ein kleineres Volumen oder mehr freier Speicher</translation>
    </message>
    <message>
        <source>its axes are not finite numbers</source>
        <translation>seine Achsen sind keine endlichen Zahlen</translation>
    </message>
    <message>
        <source>its voxels are incomplete</source>
        <translation>seine Voxel sind unvollständig</translation>
    </message>
    <message>
        <source>a valid %1 file</source>
        <translation>eine gültige %1-Datei</translation>
    </message>
    <message>
        <source>number of points read by VTK: %1, of polygons: %2</source>
        <translation>Anzahl der Punkte, die VTK gelesen hat: %1, der Vielecke: %2</translation>
    </message>
    <message>
        <source>%1 and %2</source>
        <translation>%1 und %2</translation>
    </message>
    <message>
        <source>the result of the import process is damaged: %1</source>
        <translation>das Ergebnis des Importprozesses ist beschädigt: %1</translation>
    </message>
    <message>
        <source>a result that passed all checks</source>
        <translation>ein Ergebnis, das alle Prüfungen bestanden hat</translation>
    </message>
    <message>
        <source>it is empty</source>
        <translation>es ist leer</translation>
    </message>
    <message>
        <source>its header has no end</source>
        <translation>sein Kopf hat kein Ende</translation>
    </message>
    <message>
        <source>its header is incomplete</source>
        <translation>sein Kopf ist unvollständig</translation>
    </message>
    <message>
        <source>it has an error without a message</source>
        <translation>es enthält einen Fehler ohne Meldung</translation>
    </message>
    <message>
        <source>the file name %1</source>
        <translation>der Dateiname %1</translation>
    </message>
    <message>
        <source>a file in this folder or below it</source>
        <translation>eine Datei in diesem Ordner oder darunter</translation>
    </message>
    <message>
        <source>more than %1 files</source>
        <translation>mehr als %1 Dateien</translation>
    </message>
    <message>
        <source>a VTK file without either</source>
        <translation>eine VTK-Datei ohne beides</translation>
    </message>
    <message>
        <source>a series of %1 time steps</source>
        <translation>eine Reihe von %1 Zeitschritten</translation>
    </message>
    <message>
        <source>one time step: open the file of that step</source>
        <translation>ein Zeitschritt: die Datei dieses Schritts öffnen</translation>
    </message>
    <message>
        <source>it names no files</source>
        <translation>sie nennt keine Dateien</translation>
    </message>
    <message>
        <source>at least one element %1</source>
        <translation>mindestens ein Element %1</translation>
    </message>
    <message>
        <source>no column %1</source>
        <translation>keine Spalte %1</translation>
    </message>
    <message>
        <source>a header with %1 and %2</source>
        <translation>eine Kopfzeile mit %1 und %2</translation>
    </message>
    <message>
        <source>%1 is %2</source>
        <translation>%1 ist %2</translation>
    </message>
    <message>
        <source>a number</source>
        <translation>eine Zahl</translation>
    </message>
    <message>
        <source>at least one</source>
        <translation>mindestens eines</translation>
    </message>
    <message>
        <source>%1: taken as %2, as the scene file says; not as %3</source>
        <translation>%1: als %2 gelesen, wie es die Szenendatei angibt; nicht als %3</translation>
    </message>
    <message>
        <source>the folder cannot be read: %1</source>
        <translation>der Ordner kann nicht gelesen werden: %1</translation>
    </message>
    <message>
        <source>a folder of meshes</source>
        <translation>ein Ordner mit Oberflächen</translation>
    </message>
    <message>
        <source>a folder without mesh files</source>
        <translation>ein Ordner ohne Dateien mit Oberflächen</translation>
    </message>
    <message>
        <source>%1 files in it</source>
        <translation>Dateien darin: %1</translation>
    </message>
    <message>
        <source>%1: changed since the scene was saved: found SHA-256 %2..., expected %3...; opened as it is now</source>
        <translation>%1: seit dem Speichern der Szene geändert: SHA-256 gefunden: %2..., erwartet: %3...; geöffnet, wie es jetzt ist</translation>
    </message>
    <message>
        <source>no structure %1</source>
        <translation>keine Struktur %1</translation>
    </message>
    <message>
        <source>one of that name</source>
        <translation>eine dieses Namens</translation>
    </message>
    <message>
        <source>%1: all triangles have zero area (number of triangles: %2); expected at least one with an area</source>
        <translation>%1: alle Dreiecke haben keine Fläche (Anzahl der Dreiecke: %2); erwartet: mindestens eines mit einer Fläche</translation>
    </message>
    <message>
        <source>%1: tagged SPACE=%2, but taken as %3, as was chosen</source>
        <translation>%1: mit SPACE=%2 gekennzeichnet, aber wie gewählt als %3 gelesen</translation>
    </message>
    <message>
        <source>%1: tagged SPACE=RAS: x and y negated to get LPS</source>
        <translation>%1: mit SPACE=RAS gekennzeichnet: Vorzeichen von x und y umgekehrt, um LPS zu erhalten</translation>
    </message>
    <message>
        <source>%1 and %2 more files: no SPACE tag: coordinates taken as LPS</source>
        <translation>%1 und %2 weitere Dateien: keine Angabe SPACE: Koordinaten als LPS gelesen</translation>
    </message>
    <message>
        <source>%1 and %2: no SPACE tag: coordinates taken as LPS</source>
        <translation>%1 und %2: keine Angabe SPACE: Koordinaten als LPS gelesen</translation>
    </message>
    <message>
        <source>%1: no SPACE tag: coordinates taken as LPS</source>
        <translation>%1: keine Angabe SPACE: Koordinaten als LPS gelesen</translation>
    </message>
    <message>
        <source>%1: only %2 units wide, taken as mm; looks like metres: open with --unit m</source>
        <translation>%1: nur %2 Einheiten breit, als mm gelesen; vermutlich Meter: mit --unit m öffnen</translation>
    </message>
    <message>
        <source>%1: %2 units wide, with units of %3 mm; looks like millimetres: open with --unit mm</source>
        <translation>%1: %2 Einheiten zu je %3 mm breit; vermutlich Millimeter: mit --unit mm öffnen</translation>
    </message>
    <message>
        <source>left out: %1</source>
        <translation>weggelassen: %1</translation>
    </message>
    <message>
        <source>not enough memory to open it</source>
        <translation>nicht genug Speicher zum Öffnen</translation>
    </message>
    <message>
        <source>a smaller scene, or more free memory</source>
        <translation>eine kleinere Szene oder mehr freier Speicher</translation>
    </message>
    <message>
        <source>a matrix that is not rigid</source>
        <translation>eine Matrix, die keine starre Bewegung beschreibt</translation>
    </message>
    <message>
        <source>a rotation and a translation, row by row</source>
        <translation>eine Drehung und eine Verschiebung, zeilenweise</translation>
    </message>
    <message>
        <source>at most `static`, which is %1</source>
        <translation>höchstens `static`, also %1</translation>
    </message>
    <message>
        <source>one of %1</source>
        <translation>eines von: %1</translation>
    </message>
    <message>
        <source>neither `array` nor `file`</source>
        <translation>weder `array` noch `file`</translation>
    </message>
    <message>
        <source>both `array` and `file`</source>
        <translation>sowohl `array` als auch `file`</translation>
    </message>
    <message>
        <source>the unit of the numbers: scale, N_per_mm, young_kPa or shear_kPa</source>
        <translation>die Einheit der Zahlen: scale, N_per_mm, young_kPa oder shear_kPa</translation>
    </message>
    <message>
        <source>a unit of `%1`</source>
        <translation>eine Einheit von `%1`</translation>
    </message>
    <message>
        <source>a larger number before a smaller one</source>
        <translation>eine größere Zahl vor einer kleineren</translation>
    </message>
    <message>
        <source>the minimum, then the maximum</source>
        <translation>das Minimum, dann das Maximum</translation>
    </message>
    <message>
        <source>%1 together with `inside`</source>
        <translation>%1 zusammen mit `inside`</translation>
    </message>
    <message>
        <source>one of the two: a structure felt through its organ has no layer of its own</source>
        <translation>eines von beiden: eine durch ihr Organ gefühlte Struktur hat keine eigene Schicht</translation>
    </message>
    <message>
        <source>its own name</source>
        <translation>der eigene Name</translation>
    </message>
    <message>
        <source>the name of the organ around it</source>
        <translation>der Name des Organs darum herum</translation>
    </message>
    <message>
        <source>the path of a mesh file</source>
        <translation>der Pfad einer Datei mit einer Oberfläche</translation>
    </message>
    <message>
        <source>LPS, RAS or Y-up</source>
        <translation>LPS, RAS oder Y-up</translation>
    </message>
    <message>
        <source>a fraction</source>
        <translation>ein Bruch</translation>
    </message>
    <message>
        <source>a whole number</source>
        <translation>eine ganze Zahl</translation>
    </message>
    <message>
        <source>64 hex digits</source>
        <translation>64 Hexadezimalziffern</translation>
    </message>
    <message>
        <source>the path of a recording</source>
        <translation>der Pfad einer Aufzeichnung</translation>
    </message>
    <message>
        <source>a time in UTC, e.g. %1</source>
        <translation>eine Zeit in UTC, z. B. %1</translation>
    </message>
    <message>
        <source>the name of a structure of this scene</source>
        <translation>der Name einer Struktur dieser Szene</translation>
    </message>
    <message>
        <source>`felt:` and a quantity, or `array:` and its name</source>
        <translation>`felt:` und eine Größe oder `array:` und der Name</translation>
    </message>
    <message>
        <source>%1, the name of %2 structures</source>
        <translation>%1, der Name von %2 Strukturen</translation>
    </message>
    <message>
        <source>the name of one structure: rename the others</source>
        <translation>der Name einer einzigen Struktur: die anderen umbenennen</translation>
    </message>
    <message>
        <source>%1, which lies inside %2</source>
        <translation>%1, das in %2 liegt</translation>
    </message>
    <message>
        <source>the outermost structure around it</source>
        <translation>die äußerste Struktur darum herum</translation>
    </message>
    <message>
        <source>a scene as a JSON object</source>
        <translation>eine Szene als JSON-Objekt</translation>
    </message>
    <message>
        <source>both `points` and `file`</source>
        <translation>sowohl `points` als auch `file`</translation>
    </message>
    <message>
        <source>points [[depth_mm, force_N], …] or the file of a curve</source>
        <translation>Punkte [[depth_mm, force_N], …] oder die Datei einer Kurve</translation>
    </message>
    <message>
        <source>not smoothed: too small, it would lose more than half of its volume</source>
        <translation>nicht geglättet: zu klein, sie verlöre mehr als die Hälfte ihres Volumens</translation>
    </message>
    <message>
        <source>surface from a label map of %1 × %2 × %3 mm voxels, %4</source>
        <translation>Fläche aus einer Labelkarte mit Voxeln von %1 × %2 × %3 mm, %4</translation>
    </message>
    <message>
        <source>surface from a label map of %1 × %2 × %3 mm voxels, smoothed by %4: at most %5 mm from the voxel boundary</source>
        <translation>Oberfläche aus einer Labelkarte mit Voxeln von %1 × %2 × %3 mm, geglättet mit %4: höchstens %5 mm von der Voxelgrenze</translation>
    </message>
    <message>
        <source>smoothed: vertices moved by at most %1 mm</source>
        <translation>geglättet: Eckpunkte höchstens um %1 mm verschoben</translation>
    </message>
    <message>
        <source>surface from a label map of %1 × %2 × %3 mm voxels, smoothed by %4: volume changed by %5 %, at most %6 mm from the voxel boundary</source>
        <translation>Oberfläche aus einer Labelkarte mit Voxeln von %1 × %2 × %3 mm, geglättet mit %4: Volumen um %5 % geändert, höchstens %6 mm von der Voxelgrenze</translation>
    </message>
    <message>
        <source>smoothed: vertices moved by at most %1 mm, volume %2 %</source>
        <translation>geglättet: Eckpunkte höchstens um %1 mm verschoben, Volumen %2 %</translation>
    </message>
    <message>
        <source>curved facets would be %1 triangles, expected at most %2; the surface is felt and drawn as facets</source>
        <translation>gekrümmte Facetten ergäben %1 Dreiecke, erwartet höchstens %2; die Fläche wird mit ebenen Facetten ertastet und gezeichnet</translation>
    </message>
    <message>
        <source>no facet is curved: all edges are flat or sharp</source>
        <translation>keine Facette wird gekrümmt: alle Kanten sind flach oder scharf</translation>
    </message>
    <message>
        <source>curved facets: %1 triangles instead of %2; facets kept flat, because they would fold: %3</source>
        <translation>gekrümmte Facetten: %1 Dreiecke statt %2; eben gelassen, weil sie sich falten würden: %3 Facetten</translation>
    </message>
    <message>
        <source>curved facets: %1 triangles instead of %2</source>
        <translation>gekrümmte Facetten: %1 Dreiecke statt %2</translation>
    </message>
    <message>
        <source>point %1</source>
        <translation>Punkt %1</translation>
    </message>
    <message>
        <source>it is farther than 10 km from the origin</source>
        <translation>er ist weiter als 10 km vom Ursprung entfernt</translation>
    </message>
    <message>
        <source>all triangles have zero area (number of triangles: %1)</source>
        <translation>keines der Dreiecke hat eine Fläche (Anzahl der Dreiecke: %1)</translation>
    </message>
    <message>
        <source>at least one with an area</source>
        <translation>mindestens eines mit einer Fläche</translation>
    </message>
    <message>
        <source>a mesh with arrays: this one has none</source>
        <translation>eine Oberfläche mit Datenfeldern: diese hat keine</translation>
    </message>
    <message>
        <source>the volume</source>
        <translation>das Volumen</translation>
    </message>
    <message>
        <source>%1: %2 has no value at %3 of %4 places, more than a fifth: the structure&apos;s own value is felt there</source>
        <translation>%1: %2 hat an %3 von %4 Stellen keinen Wert, mehr als einem Fünftel: dort wird der eigene Wert der Struktur gefühlt</translation>
    </message>
    <message>
        <source>%1: %2 has no value at %3 of %4 places: the structure&apos;s own value is felt there</source>
        <translation>%1: %2 hat an %3 von %4 Stellen keinen Wert: dort wird der eigene Wert der Struktur gefühlt</translation>
    </message>
    <message>
        <source>no array %1</source>
        <translation>kein Datenfeld %1</translation>
    </message>
    <message>
        <source>%1; expected %2</source>
        <translation>%1; erwartet: %2</translation>
    </message>
    <message>
        <source>%1: %2: %3</source>
        <translation>%1: %2: %3</translation>
    </message>
    <message>
        <source>line %1</source>
        <translation>Zeile %1</translation>
    </message>
    <message>
        <source>byte %1</source>
        <translation>Byte %1</translation>
    </message>
    <message>
        <source>an array of %1</source>
        <translation>eine Liste von %1</translation>
    </message>
    <message>
        <source>an object</source>
        <translation>ein Objekt</translation>
    </message>
    <message>
        <source>%1: %2: found %3, expected %4</source>
        <translation>%1: %2: gefunden: %3, erwartet: %4</translation>
    </message>
    <message>
        <source>a text without the character U+0000</source>
        <translation>ein Text ohne das Zeichen U+0000</translation>
    </message>
    <message>
        <source>a text</source>
        <translation>ein Text</translation>
    </message>
    <message>
        <source>true or false</source>
        <translation>true oder false</translation>
    </message>
    <message>
        <source>%1 numbers</source>
        <translation>%1 Zahlen</translation>
    </message>
    <message>
        <source>at most %1 pairs of numbers</source>
        <translation>höchstens %1 Zahlenpaare</translation>
    </message>
    <message>
        <source>two numbers</source>
        <translation>zwei Zahlen</translation>
    </message>
    <message>
        <source>an array</source>
        <translation>eine Liste</translation>
    </message>
    <message>
        <source>a byte of 0 in the header</source>
        <translation>ein Byte 0 im Kopf</translation>
    </message>
    <message>
        <source>%1 a second time</source>
        <translation>%1 ein zweites Mal</translation>
    </message>
    <message>
        <source>the header does not end</source>
        <translation>der Kopf endet nicht</translation>
    </message>
    <message>
        <source>3 or 4</source>
        <translation>3 oder 4</translation>
    </message>
    <message>
        <source>1</source>
        <translation>1</translation>
    </message>
    <message>
        <source>a type of number, as MET_UCHAR or MET_SHORT</source>
        <translation>eine Zahlenart wie MET_UCHAR oder MET_SHORT</translation>
    </message>
    <message>
        <source>True: voxels as binary numbers</source>
        <translation>True: Voxel als Binärzahlen</translation>
    </message>
    <message>
        <source>one file, or uncompressed files in a LIST</source>
        <translation>eine Datei oder unkomprimierte Dateien in einer LIST</translation>
    </message>
    <message>
        <source>the name of one file, or LIST and one name on each line</source>
        <translation>der Name einer Datei, oder LIST und ein Name in jeder Zeile</translation>
    </message>
    <message>
        <source>no complete header of a NIfTI file</source>
        <translation>kein vollständiger Kopf einer NIfTI-Datei</translation>
    </message>
    <message>
        <source>348 or 540 bytes</source>
        <translation>348 oder 540 Bytes</translation>
    </message>
    <message>
        <source>voxels in a separate .img file</source>
        <translation>Voxel in einer eigenen .img-Datei</translation>
    </message>
    <message>
        <source>a single file: save it as .nii or .nii.gz</source>
        <translation>eine einzige Datei: als .nii oder .nii.gz speichern</translation>
    </message>
    <message>
        <source>header: datatype</source>
        <translation>Kopf: datatype</translation>
    </message>
    <message>
        <source>one number for each voxel, as 2 or 4</source>
        <translation>eine Zahl je Voxel, wie 2 oder 4</translation>
    </message>
    <message>
        <source>header: vox_offset</source>
        <translation>Kopf: vox_offset</translation>
    </message>
    <message>
        <source>the byte of the first voxel, %1 or more</source>
        <translation>das Byte des ersten Voxels, %1 oder mehr</translation>
    </message>
    <message>
        <source>a field and its value</source>
        <translation>ein Feld und sein Wert</translation>
    </message>
    <message>
        <source>a type of number, as &quot;uchar&quot; or &quot;short&quot;</source>
        <translation>eine Zahlenart wie &quot;uchar&quot; oder &quot;short&quot;</translation>
    </message>
    <message>
        <source>&quot;little&quot; or &quot;big&quot;</source>
        <translation>&quot;little&quot; oder &quot;big&quot;</translation>
    </message>
    <message>
        <source>&quot;raw&quot; or &quot;gzip&quot;</source>
        <translation>&quot;raw&quot; oder &quot;gzip&quot;</translation>
    </message>
    <message>
        <source>a vector of three numbers for each axis, or none</source>
        <translation>ein Vektor aus drei Zahlen für jede Achse, oder none</translation>
    </message>
    <message>
        <source>three axes in space and, for overlapping segments, one list axis before or after them</source>
        <translation>drei Achsen im Raum und für überlappende Segmente eine Listenachse davor oder danach</translation>
    </message>
    <message>
        <source>a vector of three numbers</source>
        <translation>ein Vektor aus drei Zahlen</translation>
    </message>
    <message>
        <source>one name on each line after LIST</source>
        <translation>ein Name in jeder Zeile nach LIST</translation>
    </message>
    <message>
        <source>1 to %1 voxels</source>
        <translation>1 bis %1 Voxel</translation>
    </message>
    <message>
        <source>voxels of %1 × %2 × %3 mm</source>
        <translation>Voxel von %1 × %2 × %3 mm</translation>
    </message>
    <message>
        <source>axes that lie in one plane</source>
        <translation>Achsen, die in einer Ebene liegen</translation>
    </message>
    <message>
        <source>axes %1 and %2 are sheared by %3°</source>
        <translation>Achsen %1 und %2 sind um %3° geschert</translation>
    </message>
    <message>
        <source>perpendicular axes: resample the volume first (3D Slicer: Resample Image)</source>
        <translation>senkrechte Achsen: das Volumen zuerst neu abtasten (3D Slicer: Resample Image)</translation>
    </message>
    <message>
        <source>header: file of the voxels</source>
        <translation>Kopf: Datei der Voxel</translation>
    </message>
    <message>
        <source>%1 of %2 bytes of voxels</source>
        <translation>%1 von %2 Bytes an Voxeln</translation>
    </message>
    <message>
        <source>compressed data that are complete and undamaged</source>
        <translation>vollständige, unbeschädigte komprimierte Daten</translation>
    </message>
    <message>
        <source>all</source>
        <translation>alle</translation>
    </message>
    <message>
        <source>damaged compressed data</source>
        <translation>beschädigte komprimierte Daten</translation>
    </message>
    <message>
        <source>more bytes than its %1 voxels have</source>
        <translation>mehr Bytes, als die %1 Voxel haben</translation>
    </message>
    <message>
        <source>number of triangles to write: %1</source>
        <translation>Anzahl der zu schreibenden Dreiecke: %1</translation>
    </message>
    <message>
        <source>structure %1</source>
        <translation>Struktur %1</translation>
    </message>
    <message>
        <source>a triangle with a missing vertex</source>
        <translation>ein Dreieck, dem ein Eckpunkt fehlt</translation>
    </message>
    <message>
        <source>indices below %1</source>
        <translation>Nummern kleiner als %1</translation>
    </message>
    <message>
        <source>the extension %1</source>
        <translation>die Endung %1</translation>
    </message>
    <message>
        <source>the program has locked its memory itself</source>
        <translation>das Programm hat seinen Speicher selbst gesperrt</translation>
    </message>
    <message>
        <source>structure %1 (%2) has no surface to embed; pass StructureSource::embed to setScene, or record without surfaces</source>
        <translation>Struktur %1 (%2) hat keine Oberfläche zum Einbetten; übergeben Sie StructureSource::embed an setScene, oder zeichnen Sie ohne Oberflächen auf</translation>
    </message>
    <message>
        <source>lumps felt through their organ: %1</source>
        <translation>Knoten, durch ihr Organ gefühlt: %1</translation>
    </message>
    <message>
        <source>malignant tumour of the liver</source>
        <translation>bösartiger Lebertumor</translation>
    </message>
    <message>
        <source>benign tumour of the liver</source>
        <translation>gutartiger Lebertumor</translation>
    </message>
    <message>
        <source>tumour of the liver</source>
        <translation>Lebertumor</translation>
    </message>
    <message>
        <source>fibrotic liver</source>
        <translation>fibrotische Leber</translation>
    </message>
    <message>
        <source>cancer of the prostate</source>
        <translation>Karzinom der Prostata</translation>
    </message>
    <message>
        <source>nodule of the prostate</source>
        <translation>Knoten der Prostata</translation>
    </message>
    <message>
        <source>malignant tumour of the breast</source>
        <translation>bösartiger Brusttumor</translation>
    </message>
    <message>
        <source>benign tumour of the breast</source>
        <translation>gutartiger Brusttumor</translation>
    </message>
    <message>
        <source>tumour of the breast</source>
        <translation>Brusttumor</translation>
    </message>
    <message>
        <source>malignant nodule of the thyroid</source>
        <translation>bösartiger Schilddrüsenknoten</translation>
    </message>
    <message>
        <source>benign nodule of the thyroid</source>
        <translation>gutartiger Schilddrüsenknoten</translation>
    </message>
    <message>
        <source>nodule of the thyroid</source>
        <translation>Schilddrüsenknoten</translation>
    </message>
    <message>
        <source>cancer of the pancreas</source>
        <translation>Pankreaskarzinom</translation>
    </message>
    <message>
        <source>benign tumour of the pancreas</source>
        <translation>gutartiger Pankreastumor</translation>
    </message>
    <message>
        <source>tumour of the pancreas</source>
        <translation>Pankreastumor</translation>
    </message>
    <message>
        <source>cyst</source>
        <translation>Zyste</translation>
    </message>
    <message>
        <source>vessel</source>
        <translation>Gefäß</translation>
    </message>
    <message>
        <source>%1 %2 (%3 to %4)</source>
        <translation>%1 %2 (%3 bis %4)</translation>
    </message>
    <message>
        <source>%1 %2</source>
        <translation>%1 %2</translation>
    </message>
    <message>
        <source>%1: the stiffness ratio to %2 is not known, so no verdict is given; expected a ratio, as --ratio &quot;%1=R&quot; or `young_ratio` in a scene file. Published: %3</source>
        <translation>%1: das Steifigkeitsverhältnis zu %2 ist nicht bekannt, daher kein Urteil; erwartet: ein Verhältnis, als --ratio &quot;%1=R&quot; oder `young_ratio` in einer Szenendatei. Veröffentlicht: %3</translation>
    </message>
    <message>
        <source>%1 and %2 are the same surface twice</source>
        <translation>%1 und %2 sind zweimal dieselbe Oberfläche</translation>
    </message>
    <message>
        <source>%1 lies in %2, which is felt in the last of %3 layers: both are felt in that one</source>
        <translation>%1 liegt in %2, das in der letzten von %3 Schichten gefühlt wird: beide werden in dieser gefühlt</translation>
    </message>
    <message>
        <source>%1 lies in %2 and is felt below it</source>
        <translation>%1 liegt in %2 und wird darunter gefühlt</translation>
    </message>
    <message>
        <source>%1 seems to lie in %2, whose surface is open or inside out: it is not felt below it</source>
        <translation>%1 liegt wohl in %2, dessen Oberfläche offen oder umgestülpt ist: es wird nicht darunter gefühlt</translation>
    </message>
    <message>
        <source>%1 and %2 come within %3 mm of each other at (%4, %5, %6) without touching: a point falls into the gap, a fingertip of 0.5 mm or more rides over it</source>
        <translation>%1 und %2 kommen sich bei (%4, %5, %6) auf %3 mm nahe, ohne sich zu berühren: Ein Punkt fällt in den Spalt, eine Fingerspitze ab 0,5 mm gleitet darüber</translation>
    </message>
    <message>
        <source>%1 and %2 touch in one layer and differ %3-fold in stiffness: the force steps at the seam</source>
        <translation>%1 und %2 berühren sich in einer Schicht, und ihre Steifigkeiten unterscheiden sich um das %3-Fache: an der Naht springt die Kraft</translation>
    </message>
    <message>
        <source>%1 lies in %2 and in the same layer: it is never felt; a deeper layer lets it be felt (--layers auto for mesh files, the field layer in a scene file)</source>
        <translation>%1 liegt in %2 und in derselben Schicht: es ist nie zu fühlen; in einer tieferen Schicht wird es fühlbar (--layers auto für Oberflächendateien, das Feld layer in einer Szenendatei)</translation>
    </message>
    <message>
        <source>%1 lies in %2 and in the same layer: it is felt only where it reaches out; a deeper layer lets it be felt (--layers auto for mesh files, the field layer in a scene file)</source>
        <translation>%1 liegt in %2 und in derselben Schicht: es ist nur dort zu fühlen, wo es herausragt; in einer tieferen Schicht wird es fühlbar (--layers auto für Oberflächendateien, das Feld layer in einer Szenendatei)</translation>
    </message>
    <message>
        <source>%1: %2: %3 (and %4 more)</source>
        <translation>%1: %2: %3 (und %4 weitere)</translation>
    </message>
    <message>
        <source>found version %1, expected 1.0: read as far as it is the same</source>
        <translation>gefunden: Version %1, erwartet: 1.0; gelesen, soweit sie übereinstimmt</translation>
    </message>
    <message>
        <source>found no version, expected 1.0: read as far as it is the same</source>
        <translation>keine Version gefunden, erwartet: 1.0; gelesen, soweit sie übereinstimmt</translation>
    </message>
    <message>
        <source>found %1, expected LPS or RAS: the list is left out</source>
        <translation>gefunden: %1, erwartet: LPS oder RAS; die Liste wird weggelassen</translation>
    </message>
    <message>
        <source>found another unit, expected mm or um: the list is left out</source>
        <translation>andere Einheit gefunden, erwartet: mm oder um; die Liste wird weggelassen</translation>
    </message>
    <message>
        <source>found more than %1 points: left out</source>
        <translation>mehr als %1 Punkte gefunden: weggelassen</translation>
    </message>
    <message>
        <source>found no position: left out</source>
        <translation>keine Position gefunden: weggelassen</translation>
    </message>
    <message>
        <source>found a coordinate that is not a number within 10⁷ mm: left out</source>
        <translation>Koordinate gefunden, die keine Zahl bis 10⁷ mm ist: weggelassen</translation>
    </message>
    <message>
        <source>found a text of %1 characters, expected at most %2: shortened</source>
        <translation>Text von %1 Zeichen gefunden, erwartet: höchstens %2; gekürzt</translation>
    </message>
    <message>
        <source>%1: found none of the surfaces that it was made on: %2</source>
        <translation>%1: keine der Oberflächen gefunden, auf denen sie aufgezeichnet wurde: %2</translation>
    </message>
    <message>
        <source>it contains none and names no mesh</source>
        <translation>sie enthält keine und nennt keine Datei</translation>
    </message>
    <message>
        <source>%1: %2: no such file, neither where it was nor beside the recording</source>
        <translation>%1: %2: die Datei ist nicht da, weder am alten Ort noch neben der Aufzeichnung</translation>
    </message>
    <message>
        <source>%1: %2: is another surface now than was recorded; opened as it is now</source>
        <translation>%1: %2: ist jetzt eine andere Oberfläche als bei der Aufzeichnung; geöffnet, wie sie jetzt ist</translation>
    </message>
    <message>
        <source>%1: its recorded map is of another surface; it is not felt</source>
        <translation>%1: die aufgezeichnete Karte gehört zu einer anderen Oberfläche; sie wird nicht gefühlt</translation>
    </message>
    <message>
        <source>%1: the recorded effect of its lumps is of another surface; it is not felt</source>
        <translation>%1: die aufgezeichnete Wirkung der Knoten gehört zu einer anderen Oberfläche; sie wird nicht gefühlt</translation>
    </message>
    <message>
        <source>%1 (in English)</source>
        <translation>%1 (auf Englisch)</translation>
    </message>
    <message>
        <source>polygon %1 has %2 corners, expected 3 to %3</source>
        <translation>Polygon %1 hat %2 Ecken, erwartet 3 bis %3</translation>
    </message>
    <message>
        <source>polygon %1 uses point %2, expected 0 to %3</source>
        <translation>Polygon %1 verwendet Punkt %2, erwartet 0 bis %3</translation>
    </message>
    <message>
        <source>found no points, expected a surface; was the filter before it updated?</source>
        <translation>keine Punkte gefunden, erwartet eine Oberfläche; wurde der Filter davor aktualisiert?</translation>
    </message>
    <message>
        <source>unit_mm: found %1, expected more than 0 and at most %2</source>
        <translation>unit_mm: %1 gefunden, erwartet mehr als 0 und höchstens %2</translation>
    </message>
    <message>
        <source>found %1 values for %2 vertices and %3 points, expected one for each vertex of a surface from surfaceOf</source>
        <translation>%1 Werte für %2 Eckpunkte und %3 Punkte gefunden, erwartet einer je Eckpunkt einer Oberfläche von surfaceOf</translation>
    </message>
    <message>
        <source>%1 is not what the generator makes</source>
        <translation>%1 ist nicht, was der Generator erzeugt</translation>
    </message>
    <message>
        <source>%1: tick %2 is not what the generator makes</source>
        <translation>%1: Takt %2 ist nicht, was der Generator erzeugt</translation>
    </message>
    <message>
        <source>its coordinates are not finite numbers</source>
        <translation>seine Koordinaten sind keine endlichen Zahlen</translation>
    </message>
    <message>
        <source>%1: the recording holds no tick; there is nothing to play</source>
        <translation>%1: die Aufzeichnung enthält keinen Takt; es gibt nichts abzuspielen</translation>
    </message>
    <message>
        <source>%1 includes what it encloses, %2 voxels of other labels</source>
        <translation>%1 enthält, was es umschließt: %2 Voxel anderer Labels</translation>
    </message>
    <message>
        <source>%1: left out, %2; --close-holes closes holes</source>
        <translation>%1: ausgelassen, %2; --close-holes schließt Löcher</translation>
    </message>
    <message>
        <source>found no device plugin called &quot;%1&quot;, expected one of: %2 (the built-in devices %3 are not plugins)</source>
        <translation>kein Geräte-Plugin namens „%1“ gefunden, erwartet eines von: %2 (die eingebauten Geräte %3 sind keine Plugins)</translation>
    </message>
    <message>
        <source>found %1 vertices and a lattice of %2 mm, expected more than 0</source>
        <translation>%1 Eckpunkte und ein Gitter von %2 mm gefunden, erwartet wird mehr als 0</translation>
    </message>
    <message>
        <source>frame %1: found %2 vertices, expected %3 as at rest</source>
        <translation>Bild %1: %2 Eckpunkte gefunden, erwartet werden %3 wie in Ruhe</translation>
    </message>
    <message>
        <source>frame %1, vertex %2: found a number that is not finite</source>
        <translation>Bild %1, Eckpunkt %2: eine Zahl ist nicht endlich</translation>
    </message>
    <message>
        <source>frame %1, vertex %2: found %3 mm between the shape and the lattice of %4 mm, expected at most %5 mm: use a finer lattice, or one structure for each part that slides</source>
        <translation>Bild %1, Eckpunkt %2: %3 mm zwischen Form und Gitter von %4 mm gefunden, erwartet werden höchstens %5 mm: ein feineres Gitter oder für jeden gleitenden Teil eine eigene Struktur verwenden</translation>
    </message>
    <message>
        <source>%1: found %2, expected %3 to %4</source>
        <translation>%1: gefunden: %2, erwartet: %3 bis %4</translation>
    </message>
    <message>
        <source>found %1 poses, expected at least two</source>
        <translation>%1 Lagen gefunden, erwartet werden mindestens zwei</translation>
    </message>
    <message>
        <source>exponent: found %1, expected an even number from 2 to %2</source>
        <translation>exponent: %1 gefunden, erwartet wird eine gerade Zahl von 2 bis %2</translation>
    </message>
    <message>
        <source>amplitude_mm, still or full: found a number that is not finite</source>
        <translation>amplitude_mm, still oder full: eine Zahl ist nicht endlich</translation>
    </message>
    <message>
        <source>frame %1: found %2 control points, expected %3</source>
        <translation>Bild %1: %2 Kontrollpunkte gefunden, erwartet werden %3</translation>
    </message>
    <message>
        <source>pose %1: found a number that is not finite</source>
        <translation>Lage %1: eine Zahl ist nicht endlich</translation>
    </message>
    <message>
        <source>pose %1: found the time %2 s after %3 s, expected ascending times</source>
        <translation>Lage %1: Zeit %2 s nach %3 s gefunden, erwartet werden aufsteigende Zeiten</translation>
    </message>
    <message>
        <source>the last pose: found another than the first, expected the same for a motion that repeats</source>
        <translation>die letzte Lage: eine andere als die erste gefunden, bei einer sich wiederholenden Bewegung wird dieselbe erwartet</translation>
    </message>
    <message>
        <source>found %1 frames, expected at least two</source>
        <translation>%1 Bilder gefunden, erwartet werden mindestens zwei</translation>
    </message>
    <message>
        <source>amplitude_mm: found more than %1 mm</source>
        <translation>amplitude_mm: mehr als %1 mm gefunden</translation>
    </message>
    <message>
        <source>lattice: expected at least one cell of a positive size</source>
        <translation>Gitter: erwartet wird mindestens eine Zelle von positiver Größe</translation>
    </message>
    <message>
        <source>lattice: found %1 control points in %2 frames, expected at most %3</source>
        <translation>Gitter: %1 Kontrollpunkte in %2 Bildern gefunden, erwartet werden höchstens %3</translation>
    </message>
    <message>
        <source>lattice: found %1 displacements, expected %2</source>
        <translation>Gitter: %1 Verschiebungen gefunden, erwartet werden %2</translation>
    </message>
    <message>
        <source>frame %1, control point %2: found the displacement %3 mm</source>
        <translation>Bild %1, Kontrollpunkt %2: Verschiebung %3 mm gefunden</translation>
    </message>
    <message>
        <source>frame %1, cell (%2, %3, %4): found a strain of up to %5 %, where the tissue may fold; expected at most %6 %</source>
        <translation>Bild %1, Zelle (%2, %3, %4): Dehnung bis %5 % gefunden, bei der das Gewebe sich falten kann; erwartet wird höchstens %6 %</translation>
    </message>
    <message>
        <source>frame %1, cell (%2, %3, %4): found a strain of up to %5 %, expected at most %6 %</source>
        <translation>Bild %1, Zelle (%2, %3, %4): Dehnung bis %5 % gefunden, erwartet wird höchstens %6 %</translation>
    </message>
    <message>
        <source>found %1 bytes that are no motion of this version, expected one that Palpate wrote</source>
        <translation>%1 Bytes gefunden, die keine Bewegung dieser Version sind; erwartet wird eine von Palpate geschriebene</translation>
    </message>
    <message>
        <source>found %1 layers with different motions, expected at most %2: let structures of a layer move alike</source>
        <translation>%1 Schichten mit verschiedenen Bewegungen gefunden, erwartet werden höchstens %2: die Strukturen einer Schicht gleich bewegen</translation>
    </message>
    <message>
        <source>the gzip file is cut off</source>
        <translation>die gzip-Datei ist abgeschnitten</translation>
    </message>
    <message>
        <source>the whole file</source>
        <translation>die ganze Datei</translation>
    </message>
    <message>
        <source>at most %1 times the size of the file: unpack it first (gunzip)</source>
        <translation>höchstens das %1fache der Dateigröße: zuerst entpacken (gunzip)</translation>
    </message>
    <message>
        <source>more than %1 bytes when unpacked</source>
        <translation>entpackt mehr als %1 Bytes</translation>
    </message>
    <message>
        <source>the gzip data are cut off or damaged</source>
        <translation>die gzip-Daten sind abgeschnitten oder beschädigt</translation>
    </message>
    <message>
        <source>%1 bytes, as its end states: unpack it with gunzip, which names the damage</source>
        <translation>%1 Bytes, wie am Ende angegeben: mit gunzip entpacken, das den Schaden nennt</translation>
    </message>
    <message>
        <source>a FreeSurfer surface of quadrangles, or its values</source>
        <translation>eine FreeSurfer-Oberfläche aus Vierecken oder ihre Werte</translation>
    </message>
    <message>
        <source>the files of its models, or the scene with a name that ends in .mrml</source>
        <translation>die Dateien ihrer Modelle, oder die Szene mit einem Namen, der auf .mrml endet</translation>
    </message>
    <message>
        <source>an opacity is out of range</source>
        <translation>eine Deckkraft liegt außerhalb des Bereichs</translation>
    </message>
    <message>
        <source>%1: %2 is not opened: %3</source>
        <translation>%1: %2 wird nicht geöffnet: %3</translation>
    </message>
    <message>
        <source>the scene names no file of it</source>
        <translation>die Szene nennt keine Datei dazu</translation>
    </message>
    <message>
        <source>the file %1 is not in the folder of the scene</source>
        <translation>die Datei %1 ist nicht im Ordner der Szene</translation>
    </message>
    <message>
        <source>its transform is not a rotation, shift and scale: harden it in 3D Slicer</source>
        <translation>die Transformation ist keine Drehung, Verschiebung und Skalierung: in 3D Slicer anwenden (Harden)</translation>
    </message>
    <message>
        <source>a scene without models and segmentations</source>
        <translation>eine Szene ohne Modelle und Segmentierungen</translation>
    </message>
    <message>
        <source>at least one (3D Slicer: File, Save Data)</source>
        <translation>mindestens eines (3D Slicer: File, Save Data)</translation>
    </message>
    <message>
        <source>the FreeSurfer surface ends in its header</source>
        <translation>die FreeSurfer-Oberfläche endet im Kopf</translation>
    </message>
    <message>
        <source>a text with an empty line after it, and the numbers of vertices and triangles</source>
        <translation>ein Text mit einer Leerzeile danach und die Anzahlen der Punkte und Dreiecke</translation>
    </message>
    <message>
        <source>%1 vertices and %2 triangles declared, %3 bytes behind them</source>
        <translation>%1 Punkte und %2 Dreiecke angegeben, dahinter %3 Bytes</translation>
    </message>
    <message>
        <source>moved by the centre of its volume, (%1, %2, %3) mm, to the coordinates of the scanner</source>
        <translation>um die Mitte des Volumens (%1, %2, %3) mm verschoben, in die Koordinaten des Scanners</translation>
    </message>
    <message>
        <source>%1, as declared</source>
        <translation>%1, wie angegeben</translation>
    </message>
    <message>
        <source>the data are not base64</source>
        <translation>die Daten sind kein Base64</translation>
    </message>
    <message>
        <source>base64, as declared</source>
        <translation>Base64, wie angegeben</translation>
    </message>
    <message>
        <source>the data are cut off, damaged or too long</source>
        <translation>die Daten sind abgeschnitten, beschädigt oder zu lang</translation>
    </message>
    <message>
        <source>%1 bytes, as declared</source>
        <translation>%1 Bytes, wie angegeben</translation>
    </message>
    <message>
        <source>an array of %1 × %2 numbers</source>
        <translation>ein Feld von %1 × %2 Zahlen</translation>
    </message>
    <message>
        <source>three numbers for each point or triangle, as many as its %1 bytes can hold</source>
        <translation>drei Zahlen je Punkt oder Dreieck, so viele, wie die %1 Bytes enthalten können</translation>
    </message>
    <message>
        <source>numbers of the type %1 in the encoding %2</source>
        <translation>Zahlen vom Typ %1 in der Kodierung %2</translation>
    </message>
    <message>
        <source>%1 in ASCII, Base64Binary or GZipBase64Binary (wb_command -gifti-convert)</source>
        <translation>%1 in ASCII, Base64Binary oder GZipBase64Binary (wb_command -gifti-convert)</translation>
    </message>
    <message>
        <source>an array without data</source>
        <translation>ein Feld ohne Daten</translation>
    </message>
    <message>
        <source>a coordinate transform without 16 finite numbers</source>
        <translation>eine Koordinatentransformation ohne 16 endliche Zahlen</translation>
    </message>
    <message>
        <source>4 × 4 numbers</source>
        <translation>4 × 4 Zahlen</translation>
    </message>
    <message>
        <source>a second array of %1</source>
        <translation>ein zweites Feld %1</translation>
    </message>
    <message>
        <source>one surface in a file</source>
        <translation>eine Oberfläche je Datei</translation>
    </message>
    <message>
        <source>moved to the coordinates of the scanner, as the file states</source>
        <translation>in die Koordinaten des Scanners verschoben, wie die Datei angibt</translation>
    </message>
    <message>
        <source>a GIFTI file of values, without a surface</source>
        <translation>eine GIFTI-Datei mit Werten, ohne Oberfläche</translation>
    </message>
    <message>
        <source>arrays of points and triangles: open the surface file (.surf.gii)</source>
        <translation>Felder von Punkten und Dreiecken: die Datei der Oberfläche öffnen (.surf.gii)</translation>
    </message>
    <message>
        <source>the file ends</source>
        <translation>die Datei endet</translation>
    </message>
    <message>
        <source>the declared points and polygons</source>
        <translation>die angegebenen Punkte und Polygone</translation>
    </message>
    <message>
        <source>the MNI object has %1 in place of a count</source>
        <translation>das MNI-Objekt hat %1 an der Stelle einer Anzahl</translation>
    </message>
    <message>
        <source>a whole number up to %1, as many as its bytes can hold</source>
        <translation>eine ganze Zahl bis %1, so viele, wie die Bytes enthalten können</translation>
    </message>
    <message>
        <source>the kind of colours %1</source>
        <translation>die Art der Farben %1</translation>
    </message>
    <message>
        <source>an end of a polygon below the one before: %1</source>
        <translation>ein Polygonende unter dem vorigen: %1</translation>
    </message>
    <message>
        <source>%1 behind the last polygon</source>
        <translation>%1 hinter dem letzten Polygon</translation>
    </message>
    <message>
        <source>one object of polygons</source>
        <translation>ein Objekt aus Polygonen</translation>
    </message>
    <message>
        <source>the declared vertices and faces</source>
        <translation>die angegebenen Punkte und Flächen</translation>
    </message>
    <message>
        <source>%1: four dimensions, or binary</source>
        <translation>%1: vierdimensional oder binär</translation>
    </message>
    <message>
        <source>OFF as text with three coordinates for each vertex (MeshLab converts it)</source>
        <translation>OFF als Text mit drei Koordinaten je Punkt (MeshLab wandelt es um)</translation>
    </message>
    <message>
        <source>%1 is not a count</source>
        <translation>%1 ist keine Anzahl</translation>
    </message>
    <message>
        <source>the numbers of vertices, faces and edges</source>
        <translation>die Anzahlen der Punkte, Flächen und Kanten</translation>
    </message>
    <message>
        <source>the OFF file declares %1 vertices and %2 faces</source>
        <translation>die OFF-Datei gibt %1 Punkte und %2 Flächen an</translation>
    </message>
    <message>
        <source>three numbers for each vertex</source>
        <translation>drei Zahlen je Punkt</translation>
    </message>
    <message>
        <source>the number of corners of a face</source>
        <translation>die Anzahl der Ecken einer Fläche</translation>
    </message>
    <message>
        <source>the face has fewer corners than it declares</source>
        <translation>die Fläche hat weniger Ecken als angegeben</translation>
    </message>
    <message>
        <source>%1 vertex indices</source>
        <translation>%1 Punktnummern</translation>
    </message>
    <message>
        <source>%1 behind the last face</source>
        <translation>%1 hinter der letzten Fläche</translation>
    </message>
    <message>
        <source>%1 vertices and %2 faces, as declared</source>
        <translation>%1 Punkte und %2 Flächen, wie angegeben</translation>
    </message>
    <message>
        <source>colours, normals and further numbers of vertices and faces are not read</source>
        <translation>Farben, Normalen und weitere Zahlen der Punkte und Flächen werden nicht gelesen</translation>
    </message>
    <message>
        <source>structure &quot;%1&quot;: a map of its tissue or its motion is not there, or damaged</source>
        <translation>Struktur „%1“: eine Karte ihres Gewebes oder ihre Bewegung fehlt oder ist beschädigt</translation>
    </message>
    <message>
        <source>a map of its tissue or its motion is not in the recording, or damaged</source>
        <translation>eine Karte ihres Gewebes oder ihre Bewegung fehlt in der Aufzeichnung oder ist beschädigt</translation>
    </message>
    <message>
        <source>the surface of %1 is inside out</source>
        <translation>die Oberfläche von %1 ist umgestülpt</translation>
    </message>
    <message>
        <source>more than two triangles of %1 meet at an edge</source>
        <translation>an einer Kante von %1 treffen mehr als zwei Dreiecke zusammen</translation>
    </message>
    <message>
        <source>the surface of %1 has a hole of %2 mm</source>
        <translation>die Oberfläche von %1 hat ein Loch von %2 mm</translation>
    </message>
    <message>
        <source>the surface of %1 has %2 holes, the largest of %3 mm</source>
        <translation>die Oberfläche von %1 hat %2 Löcher, das größte von %3 mm</translation>
    </message>
    <message>
        <source>found %1, expected points or a line: left out</source>
        <translation>%1 gefunden, erwartet Punkte oder eine Linie: ausgelassen</translation>
    </message>
    <message>
        <source>found a line without two points: left out</source>
        <translation>Linie ohne zwei Punkte gefunden: ausgelassen</translation>
    </message>
    <message>
        <source>--bands: found &quot;%1&quot;, expected ascending distances in mm, as 5,10</source>
        <translation>--bands: „%1“ gefunden, erwartet werden aufsteigende Abstände in mm, etwa 5,10</translation>
    </message>
    <message>
        <source>an even number from 2 to 64</source>
        <translation>eine gerade Zahl von 2 bis 64</translation>
    </message>
    <message>
        <source>both `still_mm` and `full_mm`, or neither</source>
        <translation>sowohl `still_mm` als auch `full_mm` oder keines von beiden</translation>
    </message>
    <message>
        <source>the same place as `still_mm`</source>
        <translation>derselbe Ort wie `still_mm`</translation>
    </message>
    <message>
        <source>another place</source>
        <translation>ein anderer Ort</translation>
    </message>
    <message>
        <source>the path of a CSV file of poses</source>
        <translation>der Pfad einer CSV-Datei mit Lagen</translation>
    </message>
    <message>
        <source>%1 files</source>
        <translation>%1 Dateien</translation>
    </message>
    <message>
        <source>at least two, at equal steps of the period</source>
        <translation>mindestens zwei, in gleichen Schritten der Periode</translation>
    </message>
    <message>
        <source>a header with time_s, x, y, z and optionally qw, qx, qy, qz</source>
        <translation>eine Kopfzeile mit time_s, x, y, z und wahlweise qw, qx, qy, qz</translation>
    </message>
    <message>
        <source>a quaternion of length %1</source>
        <translation>ein Quaternion der Länge %1</translation>
    </message>
    <message>
        <source>%1 vertices</source>
        <translation>%1 Eckpunkte</translation>
    </message>
    <message>
        <source>%1 as in %2: every frame has the same mesh</source>
        <translation>%1 wie in %2: jedes Bild hat dasselbe Netz</translation>
    </message>
    <message>
        <source>%1: moves along the poses of %2</source>
        <translation>%1: bewegt sich nach den Lagen in %2</translation>
    </message>
    <message>
        <source>%1: moves by up to %2 mm in a period of %3 s, with a strain of up to %4 %</source>
        <translation>%1: bewegt sich um bis zu %2 mm mit einer Periode von %3 s und einer Dehnung bis %4 %</translation>
    </message>
    <message>
        <source>%1: its force pulses by %2 % in a period of %3 s</source>
        <translation>%1: die Kraft pulsiert um %2 % mit einer Periode von %3 s</translation>
    </message>
    <message>
        <source>%1 layers with different motions</source>
        <translation>%1 Schichten mit verschiedenen Bewegungen</translation>
    </message>
    <message>
        <source>at most %1: let the structures of a layer move alike</source>
        <translation>höchstens %1: die Strukturen einer Schicht gleich bewegen</translation>
    </message>
    <message>
        <source>at most %1 texts</source>
        <translation>höchstens %1 Texte</translation>
    </message>
    <message>
        <source>(%1, %2, %3)</source>
        <translation>(%1, %2, %3)</translation>
    </message>
    <message>
        <source>%1 to %2: 0 mm, they cross or touch at %3</source>
        <translation>%1 zu %2: 0 mm, sie schneiden oder berühren sich bei %3</translation>
    </message>
    <message>
        <source>%1 to %2: 0 mm, %1 lies inside, %3 mm from the surface, from %4 to %5</source>
        <translation>%1 zu %2: 0 mm, %1 liegt innen, %3 mm von der Oberfläche, von %4 bis %5</translation>
    </message>
    <message>
        <source>%1 to %2: 0 mm, %2 lies inside, %3 mm from the surface, from %4 to %5</source>
        <translation>%1 zu %2: 0 mm, %2 liegt innen, %3 mm von der Oberfläche, von %4 bis %5</translation>
    </message>
    <message>
        <source>%1 to %2: %3 mm, from %4 to %5</source>
        <translation>%1 zu %2: %3 mm, von %4 bis %5</translation>
    </message>
    <message>
        <source>inside: %1 %</source>
        <translation>innen: %1 %</translation>
    </message>
    <message>
        <source>no volume: no part is closed (open edges: %1, edges of more than two triangles: %2)</source>
        <translation>kein Volumen: kein Teil ist geschlossen (offene Kanten: %1, Kanten mit mehr als zwei Dreiecken: %2)</translation>
    </message>
    <message>
        <source>no volume: the surface is inside out</source>
        <translation>kein Volumen: die Innenseite der Fläche ist nach außen gekehrt</translation>
    </message>
    <message>
        <source>the volume is that of the closed parts: %1 of %2</source>
        <translation>das Volumen ist das der geschlossenen Teile: %1 von %2</translation>
    </message>
    <message>
        <source>--out: found &quot;%1&quot;, expected a name that ends in .pdf or .html</source>
        <translation>--out: &quot;%1&quot; gefunden, erwartet wurde ein Name, der auf .pdf oder .html endet</translation>
    </message>
    <message>
        <source>This report has no pictures: %1.</source>
        <translation>Dieser Bericht enthält keine Bilder: %1.</translation>
    </message>
    <message>
        <source>the report was cancelled</source>
        <translation>der Bericht wurde abgebrochen</translation>
    </message>
    <message>
        <source>Drawing the pictures</source>
        <translation>Bilder werden gezeichnet</translation>
    </message>
    <message>
        <source>Writing the report</source>
        <translation>Bericht wird geschrieben</translation>
    </message>
    <message>
        <source>a place as three numbers</source>
        <translation>einen Ort als drei Zahlen</translation>
    </message>
    <message>
        <source>%1: is a list of 3D Slicer marks, not a Palpate scene: import it into a scene as findings, with File &gt; Import findings in the window, or with `palpate findings SCENE.palpate.json --import %1 --out NEW.palpate.json`</source>
        <translation>%1: ist eine Liste von Marken aus 3D Slicer, keine Szene von Palpate: als Befunde in eine Szene einlesen, im Fenster mit Datei &gt; Befunde einlesen oder mit `palpate findings SZENE.palpate.json --import %1 --out NEU.palpate.json`</translation>
    </message>
    <message>
        <source>the path of a volume</source>
        <translation>der Pfad eines Volumens</translation>
    </message>
    <message>
        <source>%1 at %2</source>
        <translation>%1 bei %2</translation>
    </message>
    <message>
        <source>%1: %2 mm, from %3 to %4</source>
        <translation>%1: %2 mm, von %3 bis %4</translation>
    </message>
    <message>
        <source>&lt; %1 mm</source>
        <translation>&lt; %1 mm</translation>
    </message>
    <message>
        <source>%1 to %2 mm</source>
        <translation>%1 bis %2 mm</translation>
    </message>
    <message>
        <source>&gt; %1 mm</source>
        <translation>&gt; %1 mm</translation>
    </message>
    <message>
        <source>%1: %2 %</source>
        <translation>%1: %2 %</translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation>%1 %</translation>
    </message>
    <message>
        <source>+%1 %</source>
        <translation>+%1 %</translation>
    </message>
    <message>
        <source>lump</source>
        <translation>Knoten</translation>
    </message>
    <message>
        <source>hard area</source>
        <translation>harter Bereich</translation>
    </message>
    <message>
        <source>soft area</source>
        <translation>weicher Bereich</translation>
    </message>
    <message>
        <source>landmark</source>
        <translation>Orientierungspunkt</translation>
    </message>
    <message>
        <source>keep away</source>
        <translation>Abstand halten</translation>
    </message>
    <message>
        <source>other</source>
        <translation>sonstiges</translation>
    </message>
    <message>
        <source>Palpation report</source>
        <translation>Palpationsbericht</translation>
    </message>
    <message>
        <source>Research, training and planning rehearsal. Not a medical device.</source>
        <translation>Forschung, Ausbildung und Planungsübung. Kein Medizinprodukt.</translation>
    </message>
    <message>
        <source>not stated</source>
        <translation>keine Angabe</translation>
    </message>
    <message>
        <source>Case</source>
        <translation>Fall</translation>
    </message>
    <message>
        <source>Examiner</source>
        <translation>Untersucher</translation>
    </message>
    <message>
        <source>Recording</source>
        <translation>Aufzeichnung</translation>
    </message>
    <message>
        <source>Recorded</source>
        <translation>Aufgezeichnet</translation>
    </message>
    <message>
        <source>Report made</source>
        <translation>Bericht erstellt</translation>
    </message>
    <message>
        <source>The hand was in contact for %1 s of %2 s. The greatest force was %3 N, the median %4 N. Marked findings: %5.</source>
        <translation>Die Hand war %1 s von %2 s in Kontakt. Die größte Kraft betrug %3 N, der Median %4 N. Markierte Befunde: %5.</translation>
    </message>
    <message>
        <source>Views</source>
        <translation>Ansichten</translation>
    </message>
    <message>
        <source>From the front</source>
        <translation>Von vorn</translation>
    </message>
    <message>
        <source>The scene from the front with %1 findings and a scale bar.</source>
        <translation>Die Szene von vorn mit %1 Befunden und einem Maßstab.</translation>
    </message>
    <message>
        <source>From the patient&apos;s left</source>
        <translation>Von der linken Seite des Patienten</translation>
    </message>
    <message>
        <source>The scene from the left with %1 findings and a scale bar.</source>
        <translation>Die Szene von links mit %1 Befunden und einem Maßstab.</translation>
    </message>
    <message>
        <source>The scale bar holds at the depth of the middle of the picture. Numbers are those of the findings.</source>
        <translation>Der Maßstab gilt in der Tiefe der Bildmitte. Die Nummern sind die der Befunde.</translation>
    </message>
    <message>
        <source>Findings as marked by the examiner; force and depth at the time of marking</source>
        <translation>Befunde, wie vom Untersucher markiert; Kraft und Tiefe zum Zeitpunkt der Markierung</translation>
    </message>
    <message>
        <source>No.</source>
        <translation>Nr.</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Name</translation>
    </message>
    <message>
        <source>Type</source>
        <translation>Art</translation>
    </message>
    <message>
        <source>On</source>
        <translation>Auf</translation>
    </message>
    <message>
        <source>Place (x y z) [mm]</source>
        <translation>Ort (x y z) [mm]</translation>
    </message>
    <message>
        <source>Size [mm]</source>
        <translation>Größe [mm]</translation>
    </message>
    <message>
        <source>Force [N]</source>
        <translation>Kraft [N]</translation>
    </message>
    <message>
        <source>Depth [mm]</source>
        <translation>Tiefe [mm]</translation>
    </message>
    <message>
        <source>Marked at [s]</source>
        <translation>Markiert bei [s]</translation>
    </message>
    <message>
        <source>%1 %2 %3</source>
        <translation>%1 %2 %3</translation>
    </message>
    <message>
        <source>How the findings were examined: contact within %1 mm of the place</source>
        <translation>Wie die Befunde untersucht wurden: Kontakt innerhalb von %1 mm um den Ort</translation>
    </message>
    <message>
        <source>Time in contact [s]</source>
        <translation>Kontaktzeit [s]</translation>
    </message>
    <message>
        <source>Visits</source>
        <translation>Besuche</translation>
    </message>
    <message>
        <source>Mean force [N]</source>
        <translation>Mittlere Kraft [N]</translation>
    </message>
    <message>
        <source>Peak force [N]</source>
        <translation>Größte Kraft [N]</translation>
    </message>
    <message>
        <source>Findings felt through several layers, at the time of marking</source>
        <translation>Durch mehrere Schichten ertastete Befunde, zum Zeitpunkt der Markierung</translation>
    </message>
    <message>
        <source>Structure</source>
        <translation>Struktur</translation>
    </message>
    <message>
        <source>Findings</source>
        <translation>Befunde</translation>
    </message>
    <message>
        <source>No findings were marked.</source>
        <translation>Es wurden keine Befunde markiert.</translation>
    </message>
    <message>
        <source>%1. %2</source>
        <translation>%1. %2</translation>
    </message>
    <message>
        <source>The place of finding %1, %2, with a scale bar.</source>
        <translation>Der Ort von Befund %1, %2, mit einem Maßstab.</translation>
    </message>
    <message>
        <source>Pictures are shown of the first %1 of %2 findings.</source>
        <translation>Bilder gibt es von den ersten %1 von %2 Befunden.</translation>
    </message>
    <message>
        <source>Notes</source>
        <translation>Notizen</translation>
    </message>
    <message>
        <source>Notes of the examiner</source>
        <translation>Notizen des Untersuchers</translation>
    </message>
    <message>
        <source>Finding</source>
        <translation>Befund</translation>
    </message>
    <message>
        <source>Note</source>
        <translation>Notiz</translation>
    </message>
    <message>
        <source>Written at [s]</source>
        <translation>Geschrieben bei [s]</translation>
    </message>
    <message>
        <source>%1 lies inside, %2 mm from the surface</source>
        <translation>%1 liegt innen, %2 mm von der Oberfläche</translation>
    </message>
    <message>
        <source>apart</source>
        <translation>getrennt</translation>
    </message>
    <message>
        <source>From</source>
        <translation>Von</translation>
    </message>
    <message>
        <source>To</source>
        <translation>Bis</translation>
    </message>
    <message>
        <source>Distance [mm]</source>
        <translation>Abstand [mm]</translation>
    </message>
    <message>
        <source>Position</source>
        <translation>Lage</translation>
    </message>
    <message>
        <source>Margins: share of the lump&apos;s surface by its distance to the structure [%]</source>
        <translation>Sicherheitsabstände: Anteil der Knotenoberfläche nach dem Abstand zur Struktur [%]</translation>
    </message>
    <message>
        <source>Lump</source>
        <translation>Knoten</translation>
    </message>
    <message>
        <source>Inside</source>
        <translation>Innen</translation>
    </message>
    <message>
        <source>Distances and margins</source>
        <translation>Abstände und Sicherheitsabstände</translation>
    </message>
    <message>
        <source>Distances were not measured, because the scene is missing.</source>
        <translation>Abstände wurden nicht gemessen, weil die Szene fehlt.</translation>
    </message>
    <message>
        <source>There are no two structures to measure between.</source>
        <translation>Es gibt keine zwei Strukturen, zwischen denen gemessen werden könnte.</translation>
    </message>
    <message>
        <source>Volumes and areas</source>
        <translation>Volumen und Flächen</translation>
    </message>
    <message>
        <source>Sizes were not measured, because the scene is missing.</source>
        <translation>Größen wurden nicht gemessen, weil die Szene fehlt.</translation>
    </message>
    <message>
        <source>Sizes of the structures</source>
        <translation>Größen der Strukturen</translation>
    </message>
    <message>
        <source>Ball of equal volume [mm]</source>
        <translation>Kugel gleichen Volumens [mm]</translation>
    </message>
    <message>
        <source>Area [cm²]</source>
        <translation>Fläche [cm²]</translation>
    </message>
    <message>
        <source>Extent x × y × z [mm]</source>
        <translation>Ausdehnung x × y × z [mm]</translation>
    </message>
    <message>
        <source>%1 × %2 × %3</source>
        <translation>%1 × %2 × %3</translation>
    </message>
    <message>
        <source>Contact with each structure; forces are those of its own layer</source>
        <translation>Kontakt mit jeder Struktur; Kräfte sind die ihrer eigenen Schicht</translation>
    </message>
    <message>
        <source>Contact [s]</source>
        <translation>Kontakt [s]</translation>
    </message>
    <message>
        <source>Presses</source>
        <translation>Mal gedrückt</translation>
    </message>
    <message>
        <source>95th percentile [N]</source>
        <translation>95. Perzentil [N]</translation>
    </message>
    <message>
        <source>Peak depth [mm]</source>
        <translation>Größte Tiefe [mm]</translation>
    </message>
    <message>
        <source>Covered [%]</source>
        <translation>Abgetastet [%]</translation>
    </message>
    <message>
        <source>Longest dwell [s]</source>
        <translation>Längste Verweildauer [s]</translation>
    </message>
    <message>
        <source>Searching (the contact moves faster than 10 mm/s) and pressing (slower)</source>
        <translation>Suchen (der Kontakt bewegt sich schneller als 10 mm/s) und Drücken (langsamer)</translation>
    </message>
    <message>
        <source>Hand</source>
        <translation>Hand</translation>
    </message>
    <message>
        <source>Phases</source>
        <translation>Phasen</translation>
    </message>
    <message>
        <source>Time [s]</source>
        <translation>Zeit [s]</translation>
    </message>
    <message>
        <source>searching</source>
        <translation>Suchen</translation>
    </message>
    <message>
        <source>pressing</source>
        <translation>Drücken</translation>
    </message>
    <message>
        <source>Whole session</source>
        <translation>Gesamte Sitzung</translation>
    </message>
    <message>
        <source>Duration</source>
        <translation>Dauer</translation>
    </message>
    <message>
        <source>%1 s</source>
        <translation>%1 s</translation>
    </message>
    <message>
        <source>In contact</source>
        <translation>In Kontakt</translation>
    </message>
    <message>
        <source>%1 s, contacts: %2</source>
        <translation>%1 s, Kontakte: %2</translation>
    </message>
    <message>
        <source>Path of the hand</source>
        <translation>Weg der Hand</translation>
    </message>
    <message>
        <source>%1 mm</source>
        <translation>%1 mm</translation>
    </message>
    <message>
        <source>Path on the surface</source>
        <translation>Weg auf der Oberfläche</translation>
    </message>
    <message>
        <source>Force in contact</source>
        <translation>Kraft im Kontakt</translation>
    </message>
    <message>
        <source>peak %1 N, mean %2 N, median %3 N, 95th percentile %4 N</source>
        <translation>größte %1 N, mittlere %2 N, Median %3 N, 95. Perzentil %4 N</translation>
    </message>
    <message>
        <source>Depth in contact</source>
        <translation>Tiefe im Kontakt</translation>
    </message>
    <message>
        <source>peak %1 mm, mean %2 mm, 95th percentile %3 mm</source>
        <translation>größte %1 mm, mittlere %2 mm, 95. Perzentil %3 mm</translation>
    </message>
    <message>
        <source>Touch</source>
        <translation>Berührung</translation>
    </message>
    <message>
        <source>Nothing was touched.</source>
        <translation>Nichts wurde berührt.</translation>
    </message>
    <message>
        <source>Covered: share of the surface within %1 mm of the contact. 95th percentile: the force stayed below this value for 95 % of the contact time.</source>
        <translation>Abgetastet: Anteil der Oberfläche innerhalb von %1 mm um den Kontakt. 95. Perzentil: Die Kraft blieb 95 % der Kontaktzeit unter diesem Wert.</translation>
    </message>
    <message>
        <source>Force over time</source>
        <translation>Kraft über der Zeit</translation>
    </message>
    <message>
        <source>The recording contains no ticks.</source>
        <translation>Die Aufzeichnung enthält keine Ticks.</translation>
    </message>
    <message>
        <source>Smallest and greatest force of each of %1 spans of time; the numbers mark when the findings were marked</source>
        <translation>Kleinste und größte Kraft in jedem von %1 Zeitabschnitten; die Nummern zeigen, wann die Befunde markiert wurden</translation>
    </message>
    <message>
        <source>Curve of the force over %1 s, at most %2 N, with %3 findings.</source>
        <translation>Kraftverlauf über %1 s, höchstens %2 N, mit %3 Befunden.</translation>
    </message>
    <message>
        <source>Checking the recording</source>
        <translation>Aufzeichnung wird geprüft</translation>
    </message>
    <message>
        <source>Reading the surfaces</source>
        <translation>Oberflächen werden gelesen</translation>
    </message>
    <message>
        <source>Computing the recording again</source>
        <translation>Aufzeichnung wird erneut berechnet</translation>
    </message>
    <message>
        <source>Measuring</source>
        <translation>Messung läuft</translation>
    </message>
    <message>
        <source>Computing what can be felt of lumps</source>
        <translation>Tastbarkeit der Knoten wird berechnet</translation>
    </message>
    <message>
        <source>Measuring distances</source>
        <translation>Abstände werden gemessen</translation>
    </message>
    <message>
        <source>The recording was interrupted: %1.</source>
        <translation>Die Aufzeichnung wurde unterbrochen: %1.</translation>
    </message>
    <message>
        <source>Ticks missing in the recording: %1.</source>
        <translation>In der Aufzeichnung fehlende Ticks: %1.</translation>
    </message>
    <message>
        <source>The recording is damaged, or was changed after it was made. Damaged places: %1. Ticks that do not match their checksum are left out of all numbers.</source>
        <translation>Die Aufzeichnung ist beschädigt oder wurde nachträglich verändert. Beschädigte Stellen: %1. Ticks, deren Prüfsumme nicht stimmt, fehlen in allen Zahlen.</translation>
    </message>
    <message>
        <source>The recording is damaged, or was changed after it was made: %1.</source>
        <translation>Die Aufzeichnung ist beschädigt oder wurde nachträglich verändert: %1.</translation>
    </message>
    <message>
        <source>The recording was not computed again, so its forces are not verified: %1.</source>
        <translation>Die Aufzeichnung wurde nicht erneut berechnet, ihre Kräfte sind daher nicht geprüft: %1.</translation>
    </message>
    <message>
        <source>Computing the recording again gives other forces, so they are not verified: %1.</source>
        <translation>Die erneute Berechnung ergibt andere Kräfte, sie sind daher nicht geprüft: %1.</translation>
    </message>
    <message>
        <source>Surfaces not available, so without coverage: %1.</source>
        <translation>Nicht verfügbare Oberflächen, daher ohne Abdeckung: %1.</translation>
    </message>
    <message>
        <source>The scene is not available, so pictures, sizes, distances and lumps are missing: %1.</source>
        <translation>Die Szene ist nicht verfügbar, daher fehlen Bilder, Größen, Abstände und Knoten: %1.</translation>
    </message>
    <message>
        <source>not by hand</source>
        <translation>nicht mit der Hand</translation>
    </message>
    <message>
        <source>by a trained hand</source>
        <translation>mit geübter Hand</translation>
    </message>
    <message>
        <source>plainly</source>
        <translation>deutlich</translation>
    </message>
    <message>
        <source>not judged</source>
        <translation>nicht beurteilt</translation>
    </message>
    <message>
        <source>stiffness ratio not known</source>
        <translation>Steifigkeitsverhältnis unbekannt</translation>
    </message>
    <message>
        <source>%1 (at %2: %3; at %4: %5)</source>
        <translation>%1 (bei %2: %3; bei %4: %5)</translation>
    </message>
    <message>
        <source>as typed</source>
        <translation>wie eingegeben</translation>
    </message>
    <message>
        <source>from the moduli</source>
        <translation>aus den Moduln</translation>
    </message>
    <message>
        <source>from the tissues&apos; stiffness</source>
        <translation>aus der Steifigkeit der Gewebe</translation>
    </message>
    <message>
        <source>published for such lumps</source>
        <translation>veröffentlicht für solche Knoten</translation>
    </message>
    <message>
        <source>%1 (%2 to %3) times as stiff, %4</source>
        <translation>%1-mal (%2 bis %3) so steif, %4</translation>
    </message>
    <message>
        <source>%1 times as stiff, %2</source>
        <translation>%1-mal so steif, %2</translation>
    </message>
    <message>
        <source>Which lumps a hand can find, as predicted by the model of buried lumps (an estimate), with the stiffness ratio to the organ that this rests on</source>
        <translation>Welche Knoten eine Hand finden kann, nach dem Modell verborgener Knoten (eine Schätzung), mit dem zugrunde liegenden Steifigkeitsverhältnis zum Organ</translation>
    </message>
    <message>
        <source>Organ</source>
        <translation>Organ</translation>
    </message>
    <message>
        <source>Stiffness ratio</source>
        <translation>Steifigkeitsverhältnis</translation>
    </message>
    <message>
        <source>Pressed %1 mm</source>
        <translation>%1 mm gedrückt</translation>
    </message>
    <message>
        <source>Touched lightly</source>
        <translation>Leicht berührt</translation>
    </message>
    <message>
        <source>How thoroughly each lump was searched for: recorded change of the force, and estimates of the model</source>
        <translation>Wie gründlich nach jedem Knoten gesucht wurde: aufgezeichnete Änderung der Kraft und Schätzungen des Modells</translation>
    </message>
    <message>
        <source>Largest recorded change under the hand</source>
        <translation>Größte aufgezeichnete Änderung unter der Hand</translation>
    </message>
    <message>
        <source>Predicted change</source>
        <translation>Vorhergesagte Änderung</translation>
    </message>
    <message>
        <source>Area where a trained hand can feel it [cm²]</source>
        <translation>Fläche, auf der eine geübte Hand ihn spürt [cm²]</translation>
    </message>
    <message>
        <source>Pressed hard enough [%]</source>
        <translation>Fest genug gedrückt [%]</translation>
    </message>
    <message>
        <source>Lumps</source>
        <translation>Knoten</translation>
    </message>
    <message>
        <source>Lumps were not evaluated, because the scene is missing.</source>
        <translation>Knoten wurden nicht beurteilt, weil die Szene fehlt.</translation>
    </message>
    <message>
        <source>No lump in an organ could be evaluated.</source>
        <translation>Kein Knoten in einem Organ konnte beurteilt werden.</translation>
    </message>
    <message>
        <source>ball of %1 mm radius</source>
        <translation>Kugel von %1 mm Radius</translation>
    </message>
    <message>
        <source>point</source>
        <translation>Punkt</translation>
    </message>
    <message>
        <source>Device and recording conditions</source>
        <translation>Gerät und Aufzeichnungsbedingungen</translation>
    </message>
    <message>
        <source>Device</source>
        <translation>Gerät</translation>
    </message>
    <message>
        <source>Force limit of the device</source>
        <translation>Kraftgrenze des Geräts</translation>
    </message>
    <message>
        <source>%1 N</source>
        <translation>%1 N</translation>
    </message>
    <message>
        <source>Rate</source>
        <translation>Rate</translation>
    </message>
    <message>
        <source>%1 Hz</source>
        <translation>%1 Hz</translation>
    </message>
    <message>
        <source>Ticks</source>
        <translation>Ticks</translation>
    </message>
    <message>
        <source>Late ticks</source>
        <translation>Verspätete Ticks</translation>
    </message>
    <message>
        <source>Lost ticks</source>
        <translation>Verlorene Ticks</translation>
    </message>
    <message>
        <source>Fingertip</source>
        <translation>Fingerspitze</translation>
    </message>
    <message>
        <source>Distance that counts as touched</source>
        <translation>Abstand, der als berührt gilt</translation>
    </message>
    <message>
        <source>linear</source>
        <translation>linear</translation>
    </message>
    <message>
        <source>nonlinear</source>
        <translation>nichtlinear</translation>
    </message>
    <message>
        <source>with friction</source>
        <translation>mit Reibung</translation>
    </message>
    <message>
        <source>with maps or motion</source>
        <translation>mit Karten oder Bewegung</translation>
    </message>
    <message>
        <source>Tissue at the start of the recording</source>
        <translation>Gewebe zu Beginn der Aufzeichnung</translation>
    </message>
    <message>
        <source>Stiffness [N/mm]</source>
        <translation>Steifigkeit [N/mm]</translation>
    </message>
    <message>
        <source>Damping [N·s/mm]</source>
        <translation>Dämpfung [N·s/mm]</translation>
    </message>
    <message>
        <source>Force law</source>
        <translation>Kraftgesetz</translation>
    </message>
    <message>
        <source>Layer</source>
        <translation>Schicht</translation>
    </message>
    <message>
        <source>Own surface palpable</source>
        <translation>Eigene Oberfläche tastbar</translation>
    </message>
    <message>
        <source>yes</source>
        <translation>ja</translation>
    </message>
    <message>
        <source>no</source>
        <translation>nein</translation>
    </message>
    <message>
        <source>Not computed again: %1.</source>
        <translation>Nicht erneut berechnet: %1.</translation>
    </message>
    <message>
        <source>Ticks computed again: %1. Every position and force is the same, bit for bit.</source>
        <translation>Erneut berechnete Ticks: %1. Alle Positionen und Kräfte sind Bit für Bit gleich.</translation>
    </message>
    <message>
        <source>Ticks computed again: %1. Of these, %2 differ by rounding: by at most %3 mm and %4 N.</source>
        <translation>Erneut berechnete Ticks: %1. Davon weichen %2 durch Rundung ab: um höchstens %3 mm und %4 N.</translation>
    </message>
    <message>
        <source>Ticks computed again: %1. The forces differ by more than rounding: %2.</source>
        <translation>Erneut berechnete Ticks: %1. Die Kräfte weichen um mehr als Rundung ab: %2.</translation>
    </message>
    <message>
        <source>File</source>
        <translation>Datei</translation>
    </message>
    <message>
        <source>SHA-256</source>
        <translation>SHA-256</translation>
    </message>
    <message>
        <source>Scene</source>
        <translation>Szene</translation>
    </message>
    <message>
        <source>SHA-256 of the scene</source>
        <translation>SHA-256 der Szene</translation>
    </message>
    <message>
        <source>State</source>
        <translation>Zustand</translation>
    </message>
    <message>
        <source>Recorded by</source>
        <translation>Aufgezeichnet mit</translation>
    </message>
    <message>
        <source>Palpate %1 (%2)</source>
        <translation>Palpate %1 (%2)</translation>
    </message>
    <message>
        <source>Report made by</source>
        <translation>Bericht erstellt mit</translation>
    </message>
    <message>
        <source>Surfaces</source>
        <translation>Oberflächen</translation>
    </message>
    <message>
        <source>SHA-256 of the geometry, as palpated</source>
        <translation>SHA-256 der Geometrie, wie ertastet</translation>
    </message>
    <message>
        <source>Method</source>
        <translation>Methode</translation>
    </message>
    <message>
        <source>A hand with a haptic device, a mouse or a script palpated surface models of segmented anatomy. Forces are those of the model before any limit of the device; depths are distances between the hand and the surface. Positions and lengths are in mm in the frame LPS (x to the patient&apos;s left, y to the back, z to the head). Surfaces, and therefore distances, are as uncertain as the segmentation, about one voxel.</source>
        <translation>Eine Hand mit einem haptischen Gerät, einer Maus oder einem Skript hat Oberflächenmodelle segmentierter Anatomie abgetastet. Kräfte sind die des Modells vor jeder Begrenzung durch das Gerät; Tiefen sind Abstände zwischen Hand und Oberfläche. Positionen und Längen sind in mm im System LPS (x zur linken Seite des Patienten, y zum Rücken, z zum Kopf). Oberflächen und damit Abstände sind so unsicher wie die Segmentierung, etwa ein Voxel.</translation>
    </message>
    <message>
        <source>The recording describes no scene.</source>
        <translation>Die Aufzeichnung beschreibt keine Szene.</translation>
    </message>
    <message>
        <source>Data and verification</source>
        <translation>Daten und Prüfung</translation>
    </message>
    <message>
        <source>Database intact, checksums of %1 ticks correct.</source>
        <translation>Datenbank unversehrt, Prüfsummen von %1 Ticks richtig.</translation>
    </message>
    <message>
        <source>Damaged, or changed after it was recorded: %1.</source>
        <translation>Beschädigt oder nach der Aufzeichnung verändert: %1.</translation>
    </message>
    <message>
        <source>More damaged places: %1.</source>
        <translation>Weitere beschädigte Stellen: %1.</translation>
    </message>
    <message>
        <source>%1: found another extension, expected a name that ends in .pdf or .html</source>
        <translation>%1: andere Endung gefunden, erwartet wurde ein Name, der auf .pdf oder .html endet</translation>
    </message>
    <message>
        <source>Page %1 of %2</source>
        <translation>Seite %1 von %2</translation>
    </message>
    <message>
        <source>found no display with OpenGL to draw them; app/run.sh draws without a display</source>
        <translation>keine Anzeige mit OpenGL gefunden, um sie zu zeichnen; app/run.sh zeichnet ohne Anzeige</translation>
    </message>
    <message>
        <source>the surface of %1 is another one</source>
        <translation>die Oberfläche von %1 ist eine andere</translation>
    </message>
    <message>
        <source>%1 was palpable only in the first</source>
        <translation>%1 war nur in der ersten tastbar</translation>
    </message>
    <message>
        <source>%1 was palpable only in the second</source>
        <translation>%1 war nur in der zweiten tastbar</translation>
    </message>
    <message>
        <source>Contacts</source>
        <translation>Kontakte</translation>
    </message>
    <message>
        <source>Median force [N]</source>
        <translation>Median der Kraft [N]</translation>
    </message>
    <message>
        <source>95th percentile of the force [N]</source>
        <translation>95. Perzentil der Kraft [N]</translation>
    </message>
    <message>
        <source>Mean depth [mm]</source>
        <translation>Mittlere Tiefe [mm]</translation>
    </message>
    <message>
        <source>Searching [s]</source>
        <translation>Suchen [s]</translation>
    </message>
    <message>
        <source>Mean force when searching [N]</source>
        <translation>Mittlere Kraft beim Suchen [N]</translation>
    </message>
    <message>
        <source>Pressing [s]</source>
        <translation>Drücken [s]</translation>
    </message>
    <message>
        <source>Mean force when pressing [N]</source>
        <translation>Mittlere Kraft beim Drücken [N]</translation>
    </message>
    <message>
        <source>Duration [s]</source>
        <translation>Dauer [s]</translation>
    </message>
    <message>
        <source>Path of the hand [mm]</source>
        <translation>Weg der Hand [mm]</translation>
    </message>
    <message>
        <source>Path on the surface [mm]</source>
        <translation>Weg auf der Oberfläche [mm]</translation>
    </message>
    <message>
        <source>Marked findings</source>
        <translation>Markierte Befunde</translation>
    </message>
    <message>
        <source>Largest recorded change [%]</source>
        <translation>Größte aufgezeichnete Änderung [%]</translation>
    </message>
    <message>
        <source>%1 and %2: found recordings of different surfaces (%3), expected two recordings of the same scene</source>
        <translation>%1 und %2: Aufnahmen verschiedener Flächen gefunden (%3), erwartet zwei Aufnahmen derselben Szene</translation>
    </message>
    <message>
        <source>the check was cancelled</source>
        <translation>die Prüfung wurde abgebrochen</translation>
    </message>
    <message>
        <source>%1: found the same recording twice, expected two</source>
        <translation>%1: zweimal dieselbe Aufnahme gefunden, erwartet zwei verschiedene</translation>
    </message>
    <message>
        <source>No coverage: %1.</source>
        <translation>Keine Abdeckung: %1.</translation>
    </message>
    <message>
        <source>The fingertip was a ball of %1 mm radius in A and %2 mm in B (0: a point).</source>
        <translation>Die Fingerspitze war eine Kugel mit %1 mm Radius in A und %2 mm in B (0: ein Punkt).</translation>
    </message>
    <message>
        <source>The device was %1 in A and %2 in B.</source>
        <translation>Das Gerät war %1 in A und %2 in B.</translation>
    </message>
    <message>
        <source>The stiffness of %1 was %2 N/mm in A and %3 N/mm in B.</source>
        <translation>Die Steifigkeit von %1 war %2 N/mm in A und %3 N/mm in B.</translation>
    </message>
    <message>
        <source>The tissue of %1 was not the same in A and B.</source>
        <translation>Das Gewebe von %1 war in A und B nicht gleich.</translation>
    </message>
    <message>
        <source>%1 is damaged, or was changed after it was made. Damaged places: %2. Ticks that do not match their checksum are left out of all numbers.</source>
        <translation>%1 ist beschädigt oder wurde nach der Aufnahme geändert. Beschädigte Stellen: %2. Takte, die nicht zu ihrer Prüfsumme passen, fehlen in allen Zahlen.</translation>
    </message>
    <message>
        <source>noticeable</source>
        <translation>spürbar</translation>
    </message>
    <message>
        <source>not noticeable</source>
        <translation>nicht spürbar</translation>
    </message>
    <message>
        <source>Search for %1</source>
        <translation>Suche nach %1</translation>
    </message>
    <message>
        <source>Contact with %1</source>
        <translation>Kontakt mit %1</translation>
    </message>
    <message>
        <source>Measure</source>
        <translation>Messgröße</translation>
    </message>
    <message>
        <source>A</source>
        <translation>A</translation>
    </message>
    <message>
        <source>B</source>
        <translation>B</translation>
    </message>
    <message>
        <source>B − A</source>
        <translation>B − A</translation>
    </message>
    <message>
        <source>Relative to A</source>
        <translation>Bezogen auf A</translation>
    </message>
    <message>
        <source>By hand (7 %)</source>
        <translation>Mit der Hand (7 %)</translation>
    </message>
    <message>
        <source>Touched surface, within %1 mm of the contact</source>
        <translation>Berührte Oberfläche, bis %1 mm um den Kontakt</translation>
    </message>
    <message>
        <source>Both [cm²]</source>
        <translation>Beide [cm²]</translation>
    </message>
    <message>
        <source>Only A [cm²]</source>
        <translation>Nur A [cm²]</translation>
    </message>
    <message>
        <source>Only B [cm²]</source>
        <translation>Nur B [cm²]</translation>
    </message>
    <message>
        <source>%1 (%2 %)</source>
        <translation>%1 (%2 %)</translation>
    </message>
    <message>
        <source>Time spent, s</source>
        <translation>Verweilzeit, s</translation>
    </message>
    <message>
        <source>Largest force, N</source>
        <translation>Größte Kraft, N</translation>
    </message>
    <message>
        <source>touched: %1</source>
        <translation>berührt: %1</translation>
    </message>
    <message>
        <source>above %1: %2</source>
        <translation>über %1: %2</translation>
    </message>
    <message>
        <source>Map of touch</source>
        <translation>Karte der Berührung</translation>
    </message>
    <message>
        <source>from the front</source>
        <translation>von vorn</translation>
    </message>
    <message>
        <source>from the patient&apos;s left</source>
        <translation>von links des Patienten</translation>
    </message>
    <message>
        <source>Map of touch %1. %2, colours up to %3; %4.</source>
        <translation>Karte der Berührung %1. %2, Farben bis %3; %4.</translation>
    </message>
    <message>
        <source>The brighter a place, the longer or more firmly the contact came within %1 mm. Places in the colour of the structure were not touched. Shares refer to the surfaces of the touched structures, which are drawn opaque. The colours end at the 98th percentile, rounded up.</source>
        <translation>Je heller eine Stelle, desto länger oder fester war der Kontakt im Abstand bis %1 mm. Stellen in der Farbe der Struktur wurden nicht berührt. Anteile beziehen sich auf die Oberflächen der berührten Strukturen, die undurchsichtig gezeichnet sind. Die Farben enden am 98. Perzentil, aufgerundet.</translation>
    </message>
    <message>
        <source>forcedimension: the device with serial number %1 could not be opened: %2</source>
        <translation>forcedimension: Das Gerät mit der Seriennummer %1 konnte nicht geöffnet werden: %2</translation>
    </message>
    <message>
        <source>forcedimension: no device is connected: plug it in, switch it on, and install Palpate&apos;s udev rule (in lib/udev/rules.d)</source>
        <translation>forcedimension: Es ist kein Gerät angeschlossen: Stecken Sie es ein, schalten Sie es an und installieren Sie Palpates udev-Regel (in lib/udev/rules.d)</translation>
    </message>
    <message>
        <source>forcedimension: %1 devices are connected, expected one: choose by &quot;serial&quot; in ~/.config/Palpate/forcedimension.json; &quot;palpate devices&quot; lists the serial numbers</source>
        <translation>forcedimension: Es sind %1 Geräte angeschlossen, erwartet wird eines: Wählen Sie mit „serial“ in ~/.config/Palpate/forcedimension.json; „palpate devices“ listet die Seriennummern auf</translation>
    </message>
    <message>
        <source>forcedimension: the device could not be opened: %1</source>
        <translation>forcedimension: Das Gerät konnte nicht geöffnet werden: %1</translation>
    </message>
    <message>
        <source>forcedimension: the device is already in use by this program</source>
        <translation>forcedimension: Das Gerät wird bereits von diesem Programm benutzt</translation>
    </message>
    <message>
        <source>forcedimension: found the serial number %1, expected %2; plug the device in again</source>
        <translation>forcedimension: gefunden wurde die Seriennummer %1, erwartet wird %2; stecken Sie das Gerät neu ein</translation>
    </message>
    <message>
        <source>install the Force Dimension SDK 3 of the maker, or set &quot;library&quot; in ~/.config/Palpate/forcedimension.json to the path of libdhd.so.3</source>
        <translation>installieren Sie das Force-Dimension-SDK 3 des Herstellers, oder setzen Sie „library“ in ~/.config/Palpate/forcedimension.json auf den Pfad von libdhd.so.3</translation>
    </message>
    <message>
        <source>it is not free: close other programs that use it</source>
        <translation>es ist nicht frei: Schließen Sie andere Programme, die es benutzen</translation>
    </message>
    <message>
        <source>access is refused: install Palpate&apos;s udev rule (in lib/udev/rules.d) and plug the device in again</source>
        <translation>der Zugriff wird verweigert: Installieren Sie Palpates udev-Regel (in lib/udev/rules.d) und stecken Sie das Gerät neu ein</translation>
    </message>
    <message>
        <source>it is not connected: plug it in and switch it on</source>
        <translation>es ist nicht angeschlossen: Stecken Sie es ein und schalten Sie es an</translation>
    </message>
    <message>
        <source>forcedimension: the device was opened but gives no position; switch it off and on</source>
        <translation>forcedimension: Das Gerät wurde geöffnet, liefert aber keine Position; schalten Sie es aus und wieder an</translation>
    </message>
    <message>
        <source>This device is calibrated at the device: put the end of its handle into the calibration pit and hold it there until its light is steady.</source>
        <translation>Dieses Gerät wird am Gerät kalibriert: Stecken Sie das Ende des Griffs in die Kalibriermulde und halten Sie es dort, bis die Leuchte stetig leuchtet.</translation>
    </message>
    <message>
        <source>forcedimension: found the address &quot;%1&quot;, expected a serial number</source>
        <translation>forcedimension: gefunden wurde die Adresse „%1“, erwartet wird eine Seriennummer</translation>
    </message>
    <message>
        <source>%1: expected an object, as %2</source>
        <translation>%1: erwartet: ein Objekt wie %2</translation>
    </message>
    <message>
        <source>%1: %2 could not be loaded (%3); %4</source>
        <translation>%1: %2 konnte nicht geladen werden (%3); %4</translation>
    </message>
    <message>
        <source>%1: the library &quot;%2&quot; in the settings is a relative path, expected one that begins with /</source>
        <translation>%1: Die Bibliothek „%2“ in den Einstellungen ist ein relativer Pfad, erwartet wird einer, der mit / beginnt</translation>
    </message>
    <message>
        <source>%1: %2, the library in the settings, was not found; %3</source>
        <translation>%1: %2, die Bibliothek in den Einstellungen, wurde nicht gefunden; %3</translation>
    </message>
    <message>
        <source>%1: %2 was not found; %3</source>
        <translation>%1: %2 wurde nicht gefunden; %3</translation>
    </message>
    <message>
        <source>%1: %2 lacks %3 of the needed functions, the first is %4: another version of the library; %5</source>
        <translation>%1: %2 fehlen %3 der benötigten Funktionen, die erste ist %4: eine andere Version der Bibliothek; %5</translation>
    </message>
    <message>
        <source>%1: %2 is version %3, expected version %4; %5</source>
        <translation>%1: %2 hat Version %3, erwartet wird Version %4; %5</translation>
    </message>
    <message>
        <source>%1: found no scene file with an exercise; say where it is with --scene</source>
        <translation>%1: keine Szenendatei mit einer Übung gefunden; mit --scene den Ort angeben</translation>
    </message>
    <message>
        <source>%1: exercise: found nothing, expected the targets of an exercise</source>
        <translation>%1: exercise: nichts gefunden, erwartet die Ziele einer Übung</translation>
    </message>
    <message>
        <source>%1: no coverage of %2: its surface is missing or another one now; say where the scene is with --scene</source>
        <translation>%1: keine Abdeckung von %2: Die Oberfläche fehlt oder ist jetzt eine andere; mit --scene den Ort der Szene angeben</translation>
    </message>
    <message>
        <source>(%1, %2, %3) mm</source>
        <translation>(%1, %2, %3) mm</translation>
    </message>
    <message>
        <source>no position that the field maps to this one: it may fold</source>
        <translation>keine Position, die das Feld auf diese abbildet: es faltet sich womöglich</translation>
    </message>
    <message>
        <source>a field that can be inverted; is its direction right?</source>
        <translation>ein umkehrbares Feld; stimmt seine Richtung?</translation>
    </message>
    <message>
        <source>outside of the field</source>
        <translation>außerhalb des Feldes</translation>
    </message>
    <message>
        <source>a field that covers the structure, at rest and moved, in the same coordinates</source>
        <translation>ein Feld, das die Struktur in Ruhe und bewegt bedeckt, in denselben Koordinaten</translation>
    </message>
    <message>
        <source>the path of at least one displacement field</source>
        <translation>der Pfad mindestens eines Verschiebungsfelds</translation>
    </message>
    <message>
        <source>an unknown format</source>
        <translation>ein unbekanntes Format</translation>
    </message>
    <message>
        <source>a displacement field as .nrrd, .mha or .nii</source>
        <translation>ein Verschiebungsfeld als .nrrd, .mha oder .nii</translation>
    </message>
    <message>
        <source>a displacement field with 3</source>
        <translation>ein Verschiebungsfeld mit 3</translation>
    </message>
    <message>
        <source>3 numbers per voxel that are not marked as a vector</source>
        <translation>3 Zahlen je Voxel, die nicht als Vektor gekennzeichnet sind</translation>
    </message>
    <message>
        <source>a displacement field: the kind &quot;vector&quot; (NRRD), 3 channels (MetaImage) or the intent 1006 or 1007 (NIfTI)</source>
        <translation>ein Verschiebungsfeld: die Art &quot;vector&quot; (NRRD), 3 Kanäle (MetaImage) oder die Absicht 1006 oder 1007 (NIfTI)</translation>
    </message>
    <message>
        <source>directions that are not finite numbers</source>
        <translation>Richtungen, die keine endlichen Zahlen sind</translation>
    </message>
    <message>
        <source>three vectors of three numbers</source>
        <translation>drei Vektoren aus drei Zahlen</translation>
    </message>
    <message>
        <source>neither sform nor qform</source>
        <translation>weder sform noch qform</translation>
    </message>
    <message>
        <source>the position of its voxels</source>
        <translation>die Lage seiner Voxel</translation>
    </message>
    <message>
        <source>voxel (%1, %2, %3)</source>
        <translation>Voxel (%1, %2, %3)</translation>
    </message>
    <message>
        <source>a number that is not finite</source>
        <translation>eine Zahl, die nicht endlich ist</translation>
    </message>
    <message>
        <source>a displacement in mm</source>
        <translation>eine Verschiebung in mm</translation>
    </message>
    <message>
        <source>the name of at least one structure of this scene</source>
        <translation>den Namen mindestens einer Struktur dieser Szene</translation>
    </message>
    <message>
        <source>%1, the name of several structures</source>
        <translation>%1, den Namen mehrerer Strukturen</translation>
    </message>
    <message>
        <source>%1, which is not palpable</source>
        <translation>%1, das nicht tastbar ist</translation>
    </message>
    <message>
        <source>a structure that can be felt</source>
        <translation>eine tastbare Struktur</translation>
    </message>
    <message>
        <source>each target once</source>
        <translation>jedes Ziel einmal</translation>
    </message>
    <message>
        <source>target %1: its surface is missing or another one now; say where the scene is with --scene</source>
        <translation>Ziel %1: Die Oberfläche fehlt oder ist jetzt eine andere; mit --scene den Ort der Szene angeben</translation>
    </message>
    <message>
        <source>target %1: found no structure of that name in the recording, expected the scene that it was made on</source>
        <translation>Ziel %1: keine Struktur dieses Namens in der Aufnahme gefunden, erwartet war die Szene der Aufnahme</translation>
    </message>
    <message>
        <source>trials: found %1, expected 1 to %2</source>
        <translation>Versuche: %1 gefunden, erwartet 1 bis %2</translation>
    </message>
    <message>
        <source>places: found %1, expected 2 to %2</source>
        <translation>Stellen: %1 gefunden, erwartet 2 bis %2</translation>
    </message>
    <message>
        <source>first change: found %1 %, expected %2 to %3 %</source>
        <translation>erste Änderung: %1 % gefunden, erwartet %2 bis %3 %</translation>
    </message>
    <message>
        <source>an origin that is too far away</source>
        <translation>ein zu weit entfernter Ursprung</translation>
    </message>
    <message>
        <source>positions in mm</source>
        <translation>Positionen in mm</translation>
    </message>
    <message>
        <source>nothing written: found no recording that can be measured, expected at least one</source>
        <translation>nichts geschrieben: keine messbare Aufzeichnung gefunden, mindestens eine erwartet</translation>
    </message>
    <message>
        <source>session measure: found several recordings or a folder, expected --csv or --findings for their tables</source>
        <translation>session measure: mehrere Aufzeichnungen oder einen Ordner gefunden, --csv oder --findings für deren Tabellen erwartet</translation>
    </message>
    <message>
        <source>session measure: found --json with --csv or --findings, expected one form</source>
        <translation>session measure: --json mit --csv oder --findings gefunden, eine Form erwartet</translation>
    </message>
    <message>
        <source>--columns: found no --csv, expected the file with these columns</source>
        <translation>--columns: kein --csv gefunden, die Datei mit diesen Spalten erwartet</translation>
    </message>
    <message>
        <source>%1: found no visible surface, expected one to draw</source>
        <translation>%1: keine sichtbare Oberfläche gefunden, erwartet wird eine zum Zeichnen</translation>
    </message>
    <message>
        <source>%1: found %2 bytes, expected %3</source>
        <translation>%1: %2 Bytes gefunden, %3 erwartet</translation>
    </message>
    <message>
        <source>POSITION: expected finite numbers within 1,000,000 mm and a unit quaternion</source>
        <translation>POSITION: Endliche Zahlen bis 1.000.000 mm und ein Einheitsquaternion erwartet</translation>
    </message>
    <message>
        <source>TDATA: found %1 bytes, expected a multiple of %2</source>
        <translation>TDATA: %1 Bytes gefunden, ein Vielfaches von %2 erwartet</translation>
    </message>
    <message>
        <source>found the host %1, expected localhost or a numeric address such as 192.168.0.10</source>
        <translation>Host %1 gefunden, localhost oder eine numerische Adresse wie 192.168.0.10 erwartet</translation>
    </message>
    <message>
        <source>nothing answers at %1, port %2: %3</source>
        <translation>keine Antwort von %1, Port %2: %3</translation>
    </message>
    <message>
        <source>found the address %1, expected a numeric address such as 127.0.0.1</source>
        <translation>Adresse %1 gefunden, eine numerische Adresse wie 127.0.0.1 erwartet</translation>
    </message>
    <message>
        <source>Port %1 is used by another program, perhaps a second Palpate. Choose another port.</source>
        <translation>Port %1 wird von einem anderen Programm benutzt, vielleicht einem zweiten Palpate. Wählen Sie einen anderen Port.</translation>
    </message>
    <message>
        <source>%1, port %2: %3</source>
        <translation>%1, Port %2: %3</translation>
    </message>
    <message>
        <source>POLYDATA: %1: found %2 bytes for %3 cells</source>
        <translation>POLYDATA: %1: %2 Bytes für %3 Zellen gefunden</translation>
    </message>
    <message>
        <source>POLYDATA: %1: cell %2 has point %3, expected less than %4</source>
        <translation>POLYDATA: %1: Zelle %2 hat Punkt %3, weniger als %4 erwartet</translation>
    </message>
    <message>
        <source>POLYDATA: point %1: expected numbers within 1,000,000 mm</source>
        <translation>POLYDATA: Punkt %1: Zahlen bis 1.000.000 mm erwartet</translation>
    </message>
    <message>
        <source>POLYDATA: found no triangle</source>
        <translation>POLYDATA: Kein Dreieck gefunden</translation>
    </message>
    <message>
        <source>no direction</source>
        <translation>keine Richtung</translation>
    </message>
    <message>
        <source>three numbers that point to the hidden side</source>
        <translation>drei Zahlen, die zur verborgenen Seite zeigen</translation>
    </message>
    <message>
        <source>%1; copy the readable parts with `palpate session recover` first, then share the copy</source>
        <translation>%1; kopieren Sie zuerst die lesbaren Teile mit `palpate session recover` und geben Sie dann diese Kopie weiter</translation>
    </message>
    <message>
        <source>--columns: found &quot;%1&quot;, expected some of %2</source>
        <translation>--columns: „%1“ gefunden, eine Auswahl aus %2 erwartet</translation>
    </message>
    <message>
        <source>--columns: found &quot;%1&quot; twice, expected each column once</source>
        <translation>--columns: „%1“ zweimal gefunden, jede Spalte einmal erwartet</translation>
    </message>
    <message>
        <source>found</source>
        <translation>gefunden</translation>
    </message>
    <message>
        <source>found before</source>
        <translation>schon gefunden</translation>
    </message>
    <message>
        <source>false alarm</source>
        <translation>Fehlalarm</translation>
    </message>
    <message>
        <source>after the time limit, not counted</source>
        <translation>nach der Zeitgrenze, nicht gezählt</translation>
    </message>
    <message>
        <source>not counted: a landmark or a place to keep away from</source>
        <translation>nicht gezählt: eine Landmarke oder eine zu meidende Stelle</translation>
    </message>
    <message>
        <source>Examinee</source>
        <translation>Prüfling</translation>
    </message>
    <message>
        <source>Targets found: %1 of %2. Missed: %3. False alarms: %4.</source>
        <translation>Gefundene Ziele: %1 von %2. Verfehlt: %3. Fehlalarme: %4.</translation>
    </message>
    <message>
        <source>No coverage of %1: its surface is missing or another one now.</source>
        <translation>Keine Abdeckung von %1: Die Oberfläche fehlt oder ist jetzt eine andere.</translation>
    </message>
    <message>
        <source>Ticks lost while recording: %1.</source>
        <translation>Beim Aufzeichnen verlorene Takte: %1.</translation>
    </message>
    <message>
        <source>Targets</source>
        <translation>Ziele</translation>
    </message>
    <message>
        <source>A target is found by a finding within %1 mm of the ball around it</source>
        <translation>Ein Ziel ist gefunden, wenn ein Befund höchstens %1 mm von der Kugel darum liegt</translation>
    </message>
    <message>
        <source>Target</source>
        <translation>Ziel</translation>
    </message>
    <message>
        <source>Result</source>
        <translation>Ergebnis</translation>
    </message>
    <message>
        <source>Found after [s]</source>
        <translation>Gefunden nach [s]</translation>
    </message>
    <message>
        <source>Distance from the ball [mm]</source>
        <translation>Abstand von der Kugel [mm]</translation>
    </message>
    <message>
        <source>missed</source>
        <translation>verfehlt</translation>
    </message>
    <message>
        <source>Findings as they were at the end of the recording</source>
        <translation>Befunde, wie sie am Ende der Aufzeichnung waren</translation>
    </message>
    <message>
        <source>Search and force</source>
        <translation>Suche und Kraft</translation>
    </message>
    <message>
        <source>Time limit [s]</source>
        <translation>Zeitgrenze [s]</translation>
    </message>
    <message>
        <source>Searched share of the surface [%]</source>
        <translation>Abgesuchter Anteil der Oberfläche [%]</translation>
    </message>
    <message>
        <source>Surface to be searched [cm²]</source>
        <translation>Abzusuchende Oberfläche [cm²]</translation>
    </message>
    <message>
        <source>Distance that counts as touched [mm]</source>
        <translation>Abstand, der als berührt gilt [mm]</translation>
    </message>
    <message>
        <source>Goal of the exercise [%]</source>
        <translation>Vorgabe der Übung [%]</translation>
    </message>
    <message>
        <source>Force ceiling [N]</source>
        <translation>Kraftgrenze [N]</translation>
    </message>
    <message>
        <source>Time above the ceiling [s]</source>
        <translation>Zeit über der Grenze [s]</translation>
    </message>
    <message>
        <source>Impulse above the ceiling [N s]</source>
        <translation>Impuls über der Grenze [N s]</translation>
    </message>
    <message>
        <source>Search exercise</source>
        <translation>Suchübung</translation>
    </message>
    <message>
        <source>The targets, as seen at the end of the exercise</source>
        <translation>Die Ziele, wie am Ende der Übung zu sehen</translation>
    </message>
    <message>
        <source>The scene with a ring above each target and the findings as numbered discs.</source>
        <translation>Die Szene mit einem Ring über jedem Ziel und den Befunden als nummerierten Scheiben.</translation>
    </message>
    <message>
        <source>Places</source>
        <translation>Stellen</translation>
    </message>
    <message>
        <source>Definitions</source>
        <translation>Definitionen</translation>
    </message>
    <message>
        <source>The ball around a target has its centre in the centroid of the surface and reaches to the farthest vertex. Landmarks and places to keep away from do not count. Times are counted from the first tick of the recording. The same numbers are printed by: palpate session exercise. No grade is given.</source>
        <translation>Die Kugel um ein Ziel hat ihren Mittelpunkt im Schwerpunkt der Oberfläche und reicht bis zum fernsten Eckpunkt. Landmarken und zu meidende Stellen zählen nicht. Zeiten zählen ab dem ersten Takt der Aufzeichnung. Dieselben Zahlen gibt aus: palpate session exercise. Es gibt keine Note.</translation>
    </message>
    <message>
        <source>%1: found no recording, expected files named *.palpate</source>
        <translation>%1: keine Aufzeichnung gefunden, Dateien mit Namen *.palpate erwartet</translation>
    </message>
    <message>
        <source>%1: the folder cannot be read: %2</source>
        <translation>%1: Der Ordner kann nicht gelesen werden: %2</translation>
    </message>
    <message>
        <source>stop the recording first</source>
        <translation>beenden Sie zuerst die Aufzeichnung</translation>
    </message>
    <message>
        <source>This device is calibrated by its maker&apos;s service: attach its grip, and calibrate it as Haply Hub shows.</source>
        <translation>Dieses Gerät wird vom Dienst des Herstellers kalibriert: Stecken Sie den Griff an und kalibrieren Sie es, wie Haply Hub es zeigt.</translation>
    </message>
    <message>
        <source>haply: found version %1.%2 of the Inverse Service, expected 3.1 to 3.x; install version 3.5 with Haply Hub</source>
        <translation>haply: Version %1.%2 des Inverse Service wurde gefunden, erwartet wurde 3.1 bis 3.x; installieren Sie Version 3.5 mit Haply Hub</translation>
    </message>
    <message>
        <source>haply: the program at port %1 sends no list of devices as the Inverse Service does; set &quot;port&quot; in ~/.config/Palpate/haply.json to the service&apos;s websocket port</source>
        <translation>haply: Das Programm an Port %1 sendet keine Liste der Geräte wie der Inverse Service; setzen Sie „port“ in ~/.config/Palpate/haply.json auf den WebSocket-Port des Dienstes</translation>
    </message>
    <message>
        <source>haply: the Inverse Service has no device: connect its USB cable and its power supply, and switch it on</source>
        <translation>haply: Der Inverse Service hat kein Gerät: Schließen Sie USB-Kabel und Netzteil an, und schalten Sie es ein</translation>
    </message>
    <message>
        <source>haply: %1 devices are connected, expected one: choose by &quot;device_id&quot; in ~/.config/Palpate/haply.json; &quot;palpate devices&quot; lists the identifiers</source>
        <translation>haply: %1 Geräte sind angeschlossen, erwartet wurde eines: Wählen Sie mit „device_id“ in ~/.config/Palpate/haply.json; „palpate devices“ zeigt die Kennungen</translation>
    </message>
    <message>
        <source>haply: found no device %1, but %2; &quot;palpate devices&quot; lists the identifiers</source>
        <translation>haply: Das Gerät %1 wurde nicht gefunden, aber %2; „palpate devices“ zeigt die Kennungen</translation>
    </message>
    <message>
        <source>haply: the device %1 is already in use by this program</source>
        <translation>haply: Das Gerät %1 wird von diesem Programm bereits verwendet</translation>
    </message>
    <message>
        <source>%1: %2: expected an identifier in quotes, as &quot;049D&quot;</source>
        <translation>%1: %2: Erwartet wurde eine Kennung in Anführungszeichen, etwa &quot;049D&quot;</translation>
    </message>
    <message>
        <source>haply: the Inverse Service does not answer at port %1: install it, or start it with Haply Hub or &quot;sudo systemctl start haply-inverse-service&quot;</source>
        <translation>haply: Der Inverse Service antwortet nicht an Port %1: Installieren Sie ihn, oder starten Sie ihn mit Haply Hub oder „sudo systemctl start haply-inverse-service“</translation>
    </message>
    <message>
        <source>haply: found a program at port %1 that does not answer like the Inverse Service; set &quot;port&quot; in ~/.config/Palpate/haply.json to the service&apos;s websocket port</source>
        <translation>haply: Das Programm an Port %1 antwortet nicht wie der Inverse Service; setzen Sie „port“ in ~/.config/Palpate/haply.json auf den WebSocket-Port des Dienstes</translation>
    </message>
    <message>
        <source>haply: found &quot;%1&quot; at port %2, expected a WebSocket; set &quot;port&quot; in ~/.config/Palpate/haply.json to the service&apos;s websocket port</source>
        <translation>haply: An Port %2 wurde „%1“ gefunden, erwartet wurde ein WebSocket; setzen Sie „port“ in ~/.config/Palpate/haply.json auf den WebSocket-Port des Dienstes</translation>
    </message>
    <message>
        <source>The device is not connected.</source>
        <translation>Das Gerät ist nicht angeschlossen.</translation>
    </message>
    <message>
        <source>This device is calibrated in its inkwell: put the stylus into it, wait two seconds, and take it out.</source>
        <translation>Dieses Gerät wird in seiner Stifthalterung kalibriert: Stecken Sie den Stift hinein, warten Sie zwei Sekunden und nehmen Sie ihn heraus.</translation>
    </message>
    <message>
        <source>install OpenHaptics and the Touch driver of 3D Systems, or set &quot;library&quot; in ~/.config/Palpate/openhaptics.json to the path of libHD.so.3.4; see the page &quot;devices&quot; of the documentation</source>
        <translation>installieren Sie OpenHaptics und den Touch-Treiber von 3D Systems, oder setzen Sie „library“ in ~/.config/Palpate/openhaptics.json auf den Pfad von libHD.so.3.4; siehe die Seite „devices“ der Dokumentation</translation>
    </message>
    <message>
        <source>openhaptics: libHD is version %1, expected version 3; %2</source>
        <translation>openhaptics: libHD ist Version %1, erwartet wurde Version 3; %2</translation>
    </message>
    <message>
        <source>the licence of OpenHaptics is missing or has expired: install the licence with the maker&apos;s tools</source>
        <translation>die Lizenz von OpenHaptics fehlt oder ist abgelaufen: Installieren Sie die Lizenz mit den Programmen des Herstellers</translation>
    </message>
    <message>
        <source>it does not answer: connect its cable and its power supply, install Palpate&apos;s udev rule (in lib/udev/rules.d), and plug it in again</source>
        <translation>es antwortet nicht: Schließen Sie Kabel und Netzteil an, installieren Sie Palpates udev-Regel (in lib/udev/rules.d) und stecken Sie es neu ein</translation>
    </message>
    <message>
        <source>its configuration does not fit: run the maker&apos;s Touch_Setup; configurations are read from %1</source>
        <translation>seine Konfiguration passt nicht: Starten Sie Touch_Setup des Herstellers; Konfigurationen werden aus %1 gelesen</translation>
    </message>
    <message>
        <source>it reports a fault: disconnect its power supply, wait five seconds, and connect it again</source>
        <translation>es meldet einen Fehler: Trennen Sie das Netzteil, warten Sie fünf Sekunden und schließen Sie es wieder an</translation>
    </message>
    <message>
        <source>error %1 of libHD (%2): run the maker&apos;s Touch_Diagnostic; configurations are read from %3</source>
        <translation>Fehler %1 von libHD (%2): Starten Sie Touch_Diagnostic des Herstellers; Konfigurationen werden aus %3 gelesen</translation>
    </message>
    <message>
        <source>%1: the device is already in use by this program</source>
        <translation>%1: Das Gerät wird von diesem Programm bereits benutzt</translation>
    </message>
    <message>
        <source>openhaptics: libHD does not answer: switch the device off and on, and start Palpate again</source>
        <translation>openhaptics: libHD antwortet nicht: Schalten Sie das Gerät aus und ein und starten Sie Palpate neu</translation>
    </message>
    <message>
        <source>openhaptics: %1 devices are configured, expected one: choose by &quot;device&quot; in ~/.config/Palpate/openhaptics.json; &quot;palpate devices&quot; lists the names and the serial numbers</source>
        <translation>openhaptics: %1 Geräte sind konfiguriert, erwartet wurde eines: Wählen Sie mit „device“ in ~/.config/Palpate/openhaptics.json; „palpate devices“ zeigt die Namen und Seriennummern</translation>
    </message>
    <message>
        <source>openhaptics: no device has the name or the serial number &quot;%1&quot;: run the maker&apos;s Touch_Setup; configurations are read from %2</source>
        <translation>openhaptics: Kein Gerät hat den Namen oder die Seriennummer „%1“: Starten Sie Touch_Setup des Herstellers; Konfigurationen werden aus %2 gelesen</translation>
    </message>
    <message>
        <source>openhaptics: the device &quot;%1&quot; could not be opened: %2</source>
        <translation>openhaptics: Das Gerät „%1“ konnte nicht geöffnet werden: %2</translation>
    </message>
    <message>
        <source>openhaptics: %1 devices are in use, no more are possible</source>
        <translation>openhaptics: %1 Geräte werden benutzt, mehr sind nicht möglich</translation>
    </message>
    <message>
        <source>openhaptics: the device was opened but gives no position; switch it off and on</source>
        <translation>openhaptics: Das Gerät wurde geöffnet, liefert aber keine Position; schalten Sie es aus und ein</translation>
    </message>
    <message>
        <source>%1: device: expected the name of a configuration, or a serial number, in quotes</source>
        <translation>%1: device: Erwartet wurde der Name einer Konfiguration oder eine Seriennummer in Anführungszeichen</translation>
    </message>
    <message>
        <source>%1. Start the server there, or set host and port in openigtlink.json.</source>
        <translation>%1. Starten Sie dort den Server, oder setzen Sie host und port in openigtlink.json.</translation>
    </message>
    <message>
        <source>The positions are those of the scene, so there is no centre to set. With workspace_radius_mm in openigtlink.json, the current position becomes the centre.</source>
        <translation>Die Positionen sind die der Szene, daher gibt es keinen Mittelpunkt zu setzen. Mit workspace_radius_mm in openigtlink.json wird die aktuelle Position zum Mittelpunkt.</translation>
    </message>
    <message>
        <source>%1: found a matrix that is singular, scaled, mirrored or out of reach, expected a rotation and a position in mm</source>
        <translation>%1: Singuläre, skalierte, gespiegelte oder zu weit entfernte Matrix gefunden, eine Drehung und eine Position in mm erwartet</translation>
    </message>
    <message>
        <source>%1: %2: expected a text of at most %3 bytes in quotes</source>
        <translation>%1: %2: Ein Text von höchstens %3 Bytes in Anführungszeichen erwartet</translation>
    </message>
    <message>
        <source>%1: %2: found &quot;%3&quot;, expected &quot;RAS&quot; or &quot;LPS&quot;</source>
        <translation>%1: %2: „%3“ gefunden, „RAS“ oder „LPS“ erwartet</translation>
    </message>
    <message>
        <source>%1: library: expected the path of %2 in quotes</source>
        <translation>%1: library: Erwartet wurde der Pfad von %2 in Anführungszeichen</translation>
    </message>
    <message>
        <source>--check: found &quot;%1&quot;, expected one of %2</source>
        <translation>--check: &quot;%1&quot; gefunden, erwartet wird eines von %2</translation>
    </message>
    <message>
        <source>the device reports: %1</source>
        <translation>das Gerät meldet: %1</translation>
    </message>
    <message>
        <source>to the right</source>
        <translation>nach rechts</translation>
    </message>
    <message>
        <source>to the left</source>
        <translation>nach links</translation>
    </message>
    <message>
        <source>up</source>
        <translation>nach oben</translation>
    </message>
    <message>
        <source>down</source>
        <translation>nach unten</translation>
    </message>
    <message>
        <source>towards you</source>
        <translation>auf Sie zu</translation>
    </message>
    <message>
        <source>away from you</source>
        <translation>von Ihnen weg</translation>
    </message>
    <message>
        <source>Move the handle %1 cm to your right and hold it there.</source>
        <translation>Bewegen Sie den Griff %1 cm nach rechts und halten Sie ihn dort.</translation>
    </message>
    <message>
        <source>Hold the handle still in the middle of its workspace.</source>
        <translation>Halten Sie den Griff ruhig in der Mitte seines Arbeitsraums.</translation>
    </message>
    <message>
        <source>Move the handle %1 cm away from you and hold it there.</source>
        <translation>Bewegen Sie den Griff %1 cm von sich weg und halten Sie ihn dort.</translation>
    </message>
    <message>
        <source>Move the handle %1 cm up and hold it there.</source>
        <translation>Bewegen Sie den Griff %1 cm nach oben und halten Sie ihn dort.</translation>
    </message>
    <message>
        <source>Asked to move %1: the device follows.</source>
        <translation>Bewegung %1: Das Gerät folgt.</translation>
    </message>
    <message>
        <source>Asked to move %1: the device shows a motion %2. This axis is reversed.</source>
        <translation>Bewegung %1: Das Gerät zeigt eine Bewegung %2. Diese Achse ist umgekehrt.</translation>
    </message>
    <message>
        <source>Asked to move %1: the device shows a motion %2. This axis is another one.</source>
        <translation>Bewegung %1: Das Gerät zeigt eine Bewegung %2. Diese Achse ist vertauscht.</translation>
    </message>
    <message>
        <source>Asked to move %1: the device shows a motion between two axes, mostly %2.</source>
        <translation>Bewegung %1: Das Gerät zeigt eine Bewegung zwischen zwei Achsen, vor allem %2.</translation>
    </message>
    <message>
        <source>Asked to move %1: no such motion within %2 s.</source>
        <translation>Bewegung %1: keine solche Bewegung innerhalb von %2 s.</translation>
    </message>
    <message>
        <source>Check that %1 is calibrated and that its tooltip in the tool bar reports no problem, then repeat the check.</source>
        <translation>Prüfen Sie, ob %1 kalibriert ist und der Hinweis in der Werkzeugleiste kein Problem meldet, und wiederholen Sie die Prüfung.</translation>
    </message>
    <message>
        <source>%1 mirrors the motion: an encoder counts backwards. Do not touch with forces. Calibrate the device in its calibration pose; for WoodenHaptics, correct &quot;variant&quot; in woodenhaptics.json. Then repeat the check.</source>
        <translation>%1 spiegelt die Bewegung: Ein Encoder zählt rückwärts. Tasten Sie nicht mit Kräften. Kalibrieren Sie das Gerät in seiner Kalibrierstellung; korrigieren Sie bei WoodenHaptics &quot;variant&quot; in woodenhaptics.json. Wiederholen Sie dann die Prüfung.</translation>
    </message>
    <message>
        <source>%1 is turned: turn its base so that it faces you, then repeat the check. To align the device with the patient instead of the view, use &quot;Aligned with&quot; in the panel Device.</source>
        <translation>%1 ist verdreht: Drehen Sie den Sockel so, dass das Gerät zu Ihnen zeigt, und wiederholen Sie die Prüfung. Um das Gerät am Patienten statt an der Ansicht auszurichten, verwenden Sie die Ausrichtung im Bereich Gerät.</translation>
    </message>
    <message>
        <source>Put the handle into the middle of its workspace and let go of it. If it does not stay there by itself, hold it still.</source>
        <translation>Bringen Sie den Griff in die Mitte seines Arbeitsraums und lassen Sie ihn los. Bleibt er dort nicht von selbst, halten Sie ihn ruhig.</translation>
    </message>
    <message>
        <source>Do not touch the handle. Small forces move it.</source>
        <translation>Berühren Sie den Griff nicht. Kleine Kräfte bewegen ihn.</translation>
    </message>
    <message>
        <source>Now hold the handle like a pen, in the middle of its workspace, and keep it there.</source>
        <translation>Halten Sie den Griff jetzt wie einen Stift in der Mitte seines Arbeitsraums, und lassen Sie ihn dort.</translation>
    </message>
    <message>
        <source>Keep your hand in its place. A wall comes towards you, gives way a little and stops, and is a little stiffer each time.</source>
        <translation>Lassen Sie die Hand an ihrem Platz. Eine Wand kommt auf Sie zu, gibt etwas nach und bleibt stehen; sie ist jedes Mal etwas steifer.</translation>
    </message>
    <message>
        <source>The test was stopped.</source>
        <translation>Der Test wurde abgebrochen.</translation>
    </message>
    <message>
        <source>The device gave no position inside of its workspace. Put the handle into the middle of the workspace, calibrate the device if it needs to be, and start the test again.</source>
        <translation>Das Gerät lieferte keine Position innerhalb seines Arbeitsraums. Bringen Sie den Griff in die Mitte des Arbeitsraums, kalibrieren Sie das Gerät, falls nötig, und starten Sie den Test erneut.</translation>
    </message>
    <message>
        <source>The device has no motors, so that only the position at rest was tested.</source>
        <translation>Das Gerät hat keine Motoren; getestet wurde nur die Position in Ruhe.</translation>
    </message>
    <message>
        <source>The position did not clearly follow the force. Check that the motors have power and that forces are switched on, and start the test again without a hand at the handle until the test asks for one.</source>
        <translation>Die Position folgte der Kraft nicht eindeutig. Prüfen Sie, ob die Motoren Strom haben und Kräfte eingeschaltet sind, und starten Sie den Test erneut, ohne den Griff zu halten, bis der Test Sie darum bittet.</translation>
    </message>
    <message>
        <source>The handle moved against the force: an axis or a motor is reversed. Do not touch with this device until the settings of its driver are corrected.</source>
        <translation>Der Griff bewegte sich gegen die Kraft: Eine Achse oder ein Motor ist umgekehrt. Tasten Sie nicht mit diesem Gerät, bis die Einstellungen seines Treibers korrigiert sind.</translation>
    </message>
    <message>
        <source>Nobody held the handle, so that no wall was tested. Start the test again and hold the handle when asked.</source>
        <translation>Niemand hielt den Griff, daher wurde keine Wand getestet. Starten Sie den Test erneut und halten Sie den Griff, wenn Sie dazu aufgefordert werden.</translation>
    </message>
    <message>
        <source>The hand gave way or let go of the handle. Start the test again and keep the hand in its place.</source>
        <translation>Die Hand gab nach oder ließ den Griff los. Starten Sie den Test erneut und lassen Sie die Hand an ihrem Platz.</translation>
    </message>
    <message>
        <source>The test took too long and was stopped.</source>
        <translation>Der Test dauerte zu lange und wurde abgebrochen.</translation>
    </message>
    <message>
        <source>noise and resolution were not measured</source>
        <translation>Rauschen und Auflösung wurden nicht gemessen</translation>
    </message>
    <message>
        <source>friction was not measured: the handle did not rest</source>
        <translation>die Reibung wurde nicht gemessen: Der Griff ruhte nicht</translation>
    </message>
    <message>
        <source>friction was not measured: %1 N did not move the handle</source>
        <translation>die Reibung wurde nicht gemessen: %1 N bewegten den Griff nicht</translation>
    </message>
    <message>
        <source>the round trip was not measured</source>
        <translation>die Laufzeit wurde nicht gemessen</translation>
    </message>
    <message>
        <source>the held stiffness was not measured</source>
        <translation>die gehaltene Steifigkeit wurde nicht gemessen</translation>
    </message>
    <message>
        <source>the test is already running</source>
        <translation>der Test läuft bereits</translation>
    </message>
    <message>
        <source>not measured</source>
        <translation>nicht gemessen</translation>
    </message>
    <message>
        <source>%1 N/mm</source>
        <translation>%1 N/mm</translation>
    </message>
    <message>
        <source>less than %1 N/mm</source>
        <translation>weniger als %1 N/mm</translation>
    </message>
    <message>
        <source>Round trip</source>
        <translation>Umlaufzeit</translation>
    </message>
    <message>
        <source>%1 ms median, %2 ms 99th percentile</source>
        <translation>%1 ms Median, %2 ms 99. Perzentil</translation>
    </message>
    <message>
        <source>%1 pulses; from sending a force to seeing it act</source>
        <translation>%1 Impulse; vom Senden einer Kraft bis zur sichtbaren Wirkung</translation>
    </message>
    <message>
        <source>Mass at the handle</source>
        <translation>Masse am Griff</translation>
    </message>
    <message>
        <source>%1 g</source>
        <translation>%1 g</translation>
    </message>
    <message>
        <source>with the hand, if it was held during the pulses</source>
        <translation>mit der Hand, wenn der Griff während der Impulse gehalten wurde</translation>
    </message>
    <message>
        <source>Answer of the driver</source>
        <translation>Antwort des Treibers</translation>
    </message>
    <message>
        <source>from receiving a position to sending its force; ticks of the loop: %1</source>
        <translation>vom Empfang einer Position bis zum Senden ihrer Kraft; Takte der Schleife: %1</translation>
    </message>
    <message>
        <source>%1 new positions per second</source>
        <translation>%1 neue Positionen pro Sekunde</translation>
    </message>
    <message>
        <source>loop %1 Hz of %2 Hz, late ticks: %3</source>
        <translation>Schleife %1 Hz von %2 Hz, verspätete Takte: %3</translation>
    </message>
    <message>
        <source>Resolution</source>
        <translation>Auflösung</translation>
    </message>
    <message>
        <source>the driver states %1 mm</source>
        <translation>der Treiber gibt %1 mm an</translation>
    </message>
    <message>
        <source>Noise at rest</source>
        <translation>Rauschen in Ruhe</translation>
    </message>
    <message>
        <source>%1 mm root mean square, %2 mm peak to peak</source>
        <translation>%1 mm quadratischer Mittelwert, %2 mm von Spitze zu Spitze</translation>
    </message>
    <message>
        <source>deviation from a line over 50 ms</source>
        <translation>Abweichung von einer Geraden über 50 ms</translation>
    </message>
    <message>
        <source>Friction</source>
        <translation>Reibung</translation>
    </message>
    <message>
        <source>%1 ± %2 N</source>
        <translation>%1 ± %2 N</translation>
    </message>
    <message>
        <source>force at which the handle breaks away, in both directions</source>
        <translation>Kraft, bei der sich der Griff löst, in beiden Richtungen</translation>
    </message>
    <message>
        <source>Held stiffness, without the controller</source>
        <translation>Gehaltene Steifigkeit ohne Regler</translation>
    </message>
    <message>
        <source>Held stiffness, with the controller</source>
        <translation>Gehaltene Steifigkeit mit Regler</translation>
    </message>
    <message>
        <source>Palpate renders at most %1 N/mm on this device</source>
        <translation>Palpate gibt auf diesem Gerät höchstens %1 N/mm wieder</translation>
    </message>
    <message>
        <source>Stiffness stated for the device</source>
        <translation>Angegebene Steifigkeit des Geräts</translation>
    </message>
    <message>
        <source>%1: %2 (%3)</source>
        <translation>%1: %2 (%3)</translation>
    </message>
    <message>
        <source>%1 m³</source>
        <translation>%1 m³</translation>
    </message>
    <message>
        <source>%1 l</source>
        <translation>%1 l</translation>
    </message>
    <message>
        <source>%1 ml</source>
        <translation>%1 ml</translation>
    </message>
    <message>
        <source>%1 mm³</source>
        <translation>%1 mm³</translation>
    </message>
    <message>
        <source>%1 m²</source>
        <translation>%1 m²</translation>
    </message>
    <message>
        <source>%1 cm²</source>
        <translation>%1 cm²</translation>
    </message>
    <message>
        <source>%1 mm²</source>
        <translation>%1 mm²</translation>
    </message>
    <message>
        <source>%1 m</source>
        <translation>%1 m</translation>
    </message>
    <message>
        <source>1 hole of %1 mm closed, %2 of new surface</source>
        <translation>1 Loch von %1 mm geschlossen, %2 neue Oberfläche</translation>
    </message>
    <message>
        <source>%1 holes of up to %2 mm closed, %3 of new surface</source>
        <translation>%1 Löcher bis %2 mm geschlossen, %3 neue Oberfläche</translation>
    </message>
    <message>
        <source>area %1, extent %2 × %3 × %4 mm</source>
        <translation>Fläche %1, Ausdehnung %2 × %3 × %4 mm</translation>
    </message>
    <message>
        <source>volume %1 (a ball of %2 mm), %3</source>
        <translation>Volumen %1 (eine Kugel von %2 mm), %3</translation>
    </message>
    <message>
        <source>Findings marked outside of this recording: %1, in a table of their own.</source>
        <translation>Außerhalb dieser Aufzeichnung markierte Befunde: %1, in einer eigenen Tabelle.</translation>
    </message>
    <message>
        <source>Volume</source>
        <translation>Volumen</translation>
    </message>
    <message>
        <source>Area</source>
        <translation>Fläche</translation>
    </message>
    <message>
        <source>%1, %2 %</source>
        <translation>%1, %2 %</translation>
    </message>
    <message>
        <source>Findings marked outside of this recording: before it, after its end or in another one. This recording says nothing about their examination.</source>
        <translation>Außerhalb dieser Aufzeichnung markierte Befunde: davor, nach dem Ende oder in einer anderen. Diese Aufzeichnung sagt nichts über ihre Untersuchung.</translation>
    </message>
    <message>
        <source>Marked</source>
        <translation>Markiert</translation>
    </message>
    <message>
        <source>a count from 1 to %1 for each of %2 axes</source>
        <translation>eine Anzahl von 1 bis %1 für jede von %2 Achsen</translation>
    </message>
    <message>
        <source>0, or the bytes before uncompressed voxels, or -1 if the voxels end with their file</source>
        <translation>0, die Anzahl der Bytes vor unkomprimierten Voxeln oder -1, wenn die Voxel am Ende der Datei stehen</translation>
    </message>
    <message>
        <source>more than %1 numbers per voxel</source>
        <translation>mehr als %1 Zahlen je Voxel</translation>
    </message>
    <message>
        <source>0: voxels from the first line on</source>
        <translation>0: Voxel ab der ersten Zeile</translation>
    </message>
    <message>
        <source>%1 × %2 × %3 voxels</source>
        <translation>%1 × %2 × %3 Voxel</translation>
    </message>
    <message>
        <source>%1 × %2 × %3 voxels with %4 numbers each</source>
        <translation>%1 × %2 × %3 Voxel mit je %4 Zahlen</translation>
    </message>
    <message>
        <source>three axes that are not in one plane, with a voxel size above 0</source>
        <translation>drei Achsen, die nicht in einer Ebene liegen, und eine Voxelgröße über 0</translation>
    </message>
    <message>
        <source>%1; copy the readable parts with `palpate session recover`</source>
        <translation>%1; kopieren Sie die lesbaren Teile mit `palpate session recover`</translation>
    </message>
    <message>
        <source>%1: not made by Palpate, or damaged</source>
        <translation>%1: nicht von Palpate erstellt oder beschädigt</translation>
    </message>
    <message>
        <source>a file without them</source>
        <translation>eine Datei ohne diese</translation>
    </message>
    <message>
        <source>a line with ElementDataFile, within %1 bytes</source>
        <translation>eine Zeile mit ElementDataFile innerhalb von %1 Bytes</translation>
    </message>
    <message>
        <source>an empty line after it, within %1 bytes</source>
        <translation>eine Leerzeile danach innerhalb von %1 Bytes</translation>
    </message>
    <message>
        <source>a number for each axis in space</source>
        <translation>eine Zahl für jede räumliche Achse</translation>
    </message>
    <message>
        <source>a unit for each of three axes: &quot;mm&quot;, &quot;cm&quot;, &quot;m&quot; or &quot;um&quot;</source>
        <translation>eine Einheit für jede der drei Achsen: &quot;mm&quot;, &quot;cm&quot;, &quot;m&quot; oder &quot;um&quot;</translation>
    </message>
    <message>
        <source>an origin that is not finite</source>
        <translation>ein Ursprung, der nicht endlich ist</translation>
    </message>
    <message>
        <source>%1 with %2 bytes of voxels</source>
        <translation>%1 mit %2 Bytes an Voxeln</translation>
    </message>
    <message>
        <source>%1 in each of %2 files</source>
        <translation>%1 in jeder von %2 Dateien</translation>
    </message>
    <message>
        <source>%1 finite numbers</source>
        <translation>%1 endliche Zahlen</translation>
    </message>
    <message>
        <source>the first and last number of a voxel along each axis, at most %1 apart</source>
        <translation>die erste und letzte Nummer eines Voxels auf jeder Achse, höchstens %1 auseinander</translation>
    </message>
    <message>
        <source>%1 arrays, none of them marked as the scalars</source>
        <translation>%1 Felder, keines als Skalare gekennzeichnet</translation>
    </message>
    <message>
        <source>numbers of type %1</source>
        <translation>Zahlen vom Typ %1</translation>
    </message>
    <message>
        <source>a part of the whole, %1</source>
        <translation>ein Teil des Ganzen, %1</translation>
    </message>
    <message>
        <source>pieces that cover the whole extent</source>
        <translation>Teile, die die ganze Ausdehnung abdecken</translation>
    </message>
    <message>
        <source>a surface. As a map of stiffness, a volume is named in a scene (maps.md)</source>
        <translation>eine Oberfläche. Als Steifigkeitskarte wird ein Volumen in einer Szene genannt (maps.md)</translation>
    </message>
    <message>
        <source>the files that it names, or a name that ends in .vtm</source>
        <translation>die Dateien, die sie nennt, oder einen Namen, der auf .vtm endet</translation>
    </message>
    <message>
        <source>a volume of VTK</source>
        <translation>ein Volumen von VTK</translation>
    </message>
    <message>
        <source>a VTK file that names the parts of a surface (.pvtp)</source>
        <translation>eine VTK-Datei, die die Teile einer Oberfläche nennt (.pvtp)</translation>
    </message>
    <message>
        <source>the .vtp files that it names, in a folder</source>
        <translation>die .vtp-Dateien, die sie nennt, in einem Ordner</translation>
    </message>
    <message>
        <source>a VTK file that names the parts of a grid (.pvtu)</source>
        <translation>eine VTK-Datei, die die Teile eines Gitters nennt (.pvtu)</translation>
    </message>
    <message>
        <source>the .vtu files that it names, in a folder</source>
        <translation>die .vtu-Dateien, die sie nennt, in einem Ordner</translation>
    </message>
    <message>
        <source>a VTK file that names other files (.vtpd)</source>
        <translation>eine VTK-Datei, die andere Dateien nennt (.vtpd)</translation>
    </message>
    <message>
        <source>a VTK file that names other files (.vtpc)</source>
        <translation>eine VTK-Datei, die andere Dateien nennt (.vtpc)</translation>
    </message>
    <message>
        <source>a volume of FreeSurfer (.mgz, .mgh)</source>
        <translation>ein Volumen von FreeSurfer (.mgz, .mgh)</translation>
    </message>
    <message>
        <source>a label map as NIfTI (FreeSurfer: mri_convert to a name that ends in .nii.gz)</source>
        <translation>eine Labelkarte als NIfTI (FreeSurfer: mri_convert in eine Datei mit der Endung .nii.gz)</translation>
    </message>
    <message>
        <source>the count of triangles in the header, %1, is wrong: the size of the file says %2</source>
        <translation>die Anzahl der Dreiecke im Kopf, %1, ist falsch: nach der Dateigröße sind es %2</translation>
    </message>
    <message>
        <source>a text without the facets of an STL</source>
        <translation>ein Text ohne die Facetten einer STL-Datei</translation>
    </message>
    <message>
        <source>the text is UTF-16, but the appended data are raw bytes</source>
        <translation>der Text ist UTF-16, aber die angehängten Daten sind rohe Bytes</translation>
    </message>
    <message>
        <source>UTF-8</source>
        <translation>UTF-8</translation>
    </message>
    <message>
        <source>is a folder of DICOM images, which Palpate does not read</source>
        <translation>ist ein Ordner mit DICOM-Bildern, den Palpate nicht liest</translation>
    </message>
    <message>
        <source>a segmentation: load the DICOM images in 3D Slicer, segment the organs and save the segmentation as .seg.nrrd, or let TotalSegmentator make one; then open that file</source>
        <translation>eine Segmentierung: die DICOM-Bilder in 3D Slicer laden, die Organe segmentieren und die Segmentierung als .seg.nrrd speichern, oder sie von TotalSegmentator erstellen lassen; dann diese Datei öffnen</translation>
    </message>
    <message>
        <source>is a DICOM image, which Palpate does not read</source>
        <translation>ist ein DICOM-Bild, das Palpate nicht liest</translation>
    </message>
    <message>
        <source>a label map: whole numbers from 0, one for each structure. A CT or MR image is segmented first (3D Slicer, TotalSegmentator), or shown in the sections of an open scene (View › Section plane › Show an image…). As a map of stiffness, a volume is named in a scene (maps.md)</source>
        <translation>eine Labelkarte: ganze Zahlen ab 0, eine je Struktur. Ein CT- oder MR-Bild wird zuerst segmentiert (3D Slicer, TotalSegmentator) oder in den Schnitten einer offenen Szene gezeigt (Ansicht › Schnittebene › Bild zeigen…). Als Steifigkeitskarte wird ein Volumen in einer Szene genannt (maps.md)</translation>
    </message>
    <message>
        <source>events: %1</source>
        <translation>Ereignisse: %1</translation>
    </message>
    <message>
        <source>ticks up to %1: %2</source>
        <translation>Augenblicke bis %1: %2</translation>
    </message>
    <message>
        <source>kept, but not verified, because the checksums are lost: %1</source>
        <translation>übernommen, aber nicht geprüft, weil die Prüfsummen verloren sind: %1</translation>
    </message>
    <message>
        <source>the end may be missing: the recording was closed, but the file is damaged or cut off; nothing is known after tick %1</source>
        <translation>das Ende fehlt vielleicht: die Aufnahme wurde geschlossen, aber die Datei ist beschädigt oder abgeschnitten; nach Augenblick %1 ist nichts bekannt</translation>
    </message>
    <message>
        <source>&lt; %1</source>
        <translation>&lt; %1</translation>
    </message>
    <message>
        <source>Touched structures: %1.</source>
        <translation>Berührte Strukturen: %1.</translation>
    </message>
    <message>
        <source>%1 %2 mm</source>
        <translation>%1 %2 mm</translation>
    </message>
    <message>
        <source>Distances measured with the tape: %1 (%2).</source>
        <translation>Mit dem Maßband gemessene Abstände: %1 (%2).</translation>
    </message>
    <message>
        <source>Least distances, nearest first</source>
        <translation>Kleinste Abstände, die nächsten zuerst</translation>
    </message>
    <message>
        <source>Not listed: %1 more structures that cross or touch others.</source>
        <translation>Nicht aufgeführt: %1 weitere Strukturen, die andere schneiden oder berühren.</translation>
    </message>
    <message>
        <source>%1 crosses or touches (0 mm): %2.</source>
        <translation>%1 schneidet oder berührt (0 mm): %2.</translation>
    </message>
    <message>
        <source>Of %1 pairs of structures, %2 are left out. Listed are the nearest pairs with a structure that was touched, holds or borders a finding or the end of a tape, or is a lump. All pairs: `palpate info --distances --json SCENE`, or View › Distances and sizes in the window.</source>
        <translation>Von %1 Strukturpaaren sind %2 weggelassen. Aufgeführt sind die nächsten Paare mit einer Struktur, die berührt wurde, die einen Befund oder ein Ende eines Maßbands trägt oder daran grenzt, oder die ein Knoten ist. Alle Paare: `palpate info --distances --json SCENE`, oder Ansicht › Abstände und Größen im Fenster.</translation>
    </message>
    <message>
        <source>Margins left out, with less of the lump&apos;s surface nearby: %1. All margins: `palpate info --distances --json SCENE`.</source>
        <translation>Weggelassene Sicherheitsabstände, mit kleinerem nahem Anteil der Oberfläche des Knotens: %1. Alle Sicherheitsabstände: `palpate info --distances --json SCENE`.</translation>
    </message>
    <message>
        <source>No volume, because the surface is open, for %1 structures: %2.</source>
        <translation>Kein Volumen, weil die Oberfläche offen ist, bei %1 Strukturen: %2.</translation>
    </message>
    <message>
        <source>No volume, because the surface is inside out, for %1 structures: %2.</source>
        <translation>Kein Volumen, weil die Oberfläche umgestülpt ist, bei %1 Strukturen: %2.</translation>
    </message>
    <message>
        <source>Volume of the closed parts alone, for %1 structures: %2.</source>
        <translation>Volumen nur der geschlossenen Teile, bei %1 Strukturen: %2.</translation>
    </message>
    <message>
        <source>Measured distances</source>
        <translation>Gemessene Abstände</translation>
    </message>
    <message>
        <source>Straight distances between two places, measured by the examiner with the tape</source>
        <translation>Gerade Abstände zweier Stellen, vom Untersucher mit dem Maßband gemessen</translation>
    </message>
    <message>
        <source>Structures left out of this table: %1. All sizes: `palpate info --distances --json SCENE`.</source>
        <translation>In dieser Tabelle weggelassene Strukturen: %1. Alle Größen: `palpate info --distances --json SCENE`.</translation>
    </message>
    <message>
        <source>Surfaces without a checksum, because they were not palpable: %1.</source>
        <translation>Oberflächen ohne Prüfsumme, weil sie nicht tastbar waren: %1.</translation>
    </message>
    <message>
        <source>pieces that cover the whole extent once</source>
        <translation>Teile, die die ganze Ausdehnung einmal abdecken</translation>
    </message>
    <message>
        <source>a file in more than %1 levels or behind %2 files</source>
        <translation>eine Datei in mehr als %1 Ebenen oder nach %2 Dateien</translation>
    </message>
    <message>
        <source>fewer files that name others</source>
        <translation>weniger Dateien, die andere nennen</translation>
    </message>
    <message>
        <source>it names only itself</source>
        <translation>sie nennt nur sich selbst</translation>
    </message>
    <message>
        <source>at least one mesh file</source>
        <translation>mindestens eine Netzdatei</translation>
    </message>
</context>
<context>
    <name>palpate::app::AxisCheckDialog</name>
    <message>
        <source>Check of the axes</source>
        <translation>Prüfung der Achsen</translation>
    </message>
    <message>
        <source>All axes follow the hand.</source>
        <translation>Alle Achsen folgen der Hand.</translation>
    </message>
</context>
<context>
    <name>palpate::app::ComparisonDialog</name>
    <message>
        <source>Comparison of %1 (A) and %2 (B)</source>
        <translation>Vergleich von %1 (A) und %2 (B)</translation>
    </message>
    <message>
        <source>Comparison of two recordings</source>
        <translation>Vergleich zweier Aufnahmen</translation>
    </message>
    <message>
        <source>Measuring…</source>
        <translation>Messe…</translation>
    </message>
    <message>
        <source>Copy</source>
        <translation>Kopieren</translation>
    </message>
    <message>
        <source>Copy all tables for a spreadsheet</source>
        <translation>Alle Tabellen für eine Tabellenkalkulation kopieren</translation>
    </message>
    <message>
        <source>By hand: a hand can tell two forces apart from about 7 % on (measured from 2.5 to 10 N).</source>
        <translation>Mit der Hand: eine Hand kann zwei Kräfte ab etwa 7 % Unterschied unterscheiden (gemessen von 2,5 bis 10 N).</translation>
    </message>
</context>
<context>
    <name>palpate::app::ComparisonPart</name>
    <message>
        <source>Compare with…</source>
        <translation>Vergleichen mit…</translation>
    </message>
    <message>
        <source>Compare the recording with a second one of the same structures</source>
        <translation>Die Aufnahme mit einer zweiten derselben Strukturen vergleichen</translation>
    </message>
    <message>
        <source>End the comparison</source>
        <translation>Vergleich beenden</translation>
    </message>
    <message>
        <source>Second recording</source>
        <translation>Zweite Aufnahme</translation>
    </message>
    <message>
        <source>Recordings (*.palpate)</source>
        <translation>Aufnahmen (*.palpate)</translation>
    </message>
</context>
<context>
    <name>palpate::app::CoordinatesPart</name>
    <message>
        <source>Stop the recording first: it uses the current coordinates.</source>
        <translation>Beenden Sie zuerst die Aufzeichnung: sie verwendet die jetzigen Koordinaten.</translation>
    </message>
</context>
<context>
    <name>palpate::app::DevicePart</name>
    <message>
        <source>Device</source>
        <translation>Gerät</translation>
    </message>
    <message>
        <source>The pointer sets the place, the SpaceMouse the force: push its cap down. P palpate, wheel for the force limit</source>
        <translation>Der Zeiger bestimmt die Stelle, die SpaceMouse die Kraft: ihre Kappe nach unten drücken. P tastet, das Rad stellt die Höchstkraft ein</translation>
    </message>
    <message>
        <source>Press by effort</source>
        <translation>Mit Kraft drücken</translation>
    </message>
    <message>
        <source>Press with a set force: it rises while the button is held, or follows the pressure of a pen, and stiff tissue yields less. Off: the wheel sets the depth</source>
        <translation>Mit einer eingestellten Kraft drücken: sie wächst, solange die Taste gehalten wird, oder folgt dem Druck eines Stifts, und steifes Gewebe gibt weniger nach. Aus: das Rad stellt die Tiefe ein</translation>
    </message>
    <message>
        <source>Lift the hand</source>
        <translation>Hand anheben</translation>
    </message>
    <message>
        <source>Move the device without moving the hand in the scene, like lifting a mouse; press again to continue</source>
        <translation>Das Gerät bewegen, ohne die Hand in der Szene zu bewegen, wie beim Anheben einer Maus; noch einmal drücken: weiter</translation>
    </message>
    <message>
        <source>Fit the workspace to the scene</source>
        <translation>Arbeitsraum an die Szene anpassen</translation>
    </message>
    <message>
        <source>The workspace of the device covers everything shown</source>
        <translation>Der Arbeitsraum des Geräts umfasst alles Gezeigte</translation>
    </message>
    <message>
        <source>Fit the workspace to the organ</source>
        <translation>Arbeitsraum an das Organ anpassen</translation>
    </message>
    <message>
        <source>The workspace of the device covers the organ that is touched or under the pointer</source>
        <translation>Der Arbeitsraum des Geräts umfasst das Organ, das berührt wird oder unter dem Zeiger liegt</translation>
    </message>
    <message>
        <source>Fit the workspace to the lump</source>
        <translation>Arbeitsraum an den Knoten anpassen</translation>
    </message>
    <message>
        <source>The workspace of the device covers 10 mm around the place that is touched, under the pointer or marked</source>
        <translation>Der Arbeitsraum des Geräts umfasst 10 mm um die Stelle, die berührt wird, unter dem Zeiger liegt oder markiert ist</translation>
    </message>
    <message>
        <source>&amp;Device</source>
        <translation>&amp;Gerät</translation>
    </message>
    <message>
        <source>Touch with the device; O or L fits the workspace to the organ or lump, C lifts the hand</source>
        <translation>Mit dem Gerät tasten; O oder L passt den Arbeitsraum an Organ oder Knoten an, C hebt die Hand an</translation>
    </message>
    <message>
        <source>Restore the force</source>
        <translation>Kraft wiederherstellen</translation>
    </message>
    <message>
        <source>My threshold…</source>
        <translation>Meine Schwelle…</translation>
    </message>
    <message>
        <source>Measure the smallest increase of stiffness that your hand detects</source>
        <translation>Die kleinste Zunahme der Steifigkeit messen, die Ihre Hand bemerkt</translation>
    </message>
    <message>
        <source>Stop the recording before you measure your threshold.</source>
        <translation>Beenden Sie die Aufzeichnung, bevor Sie Ihre Schwelle messen.</translation>
    </message>
    <message>
        <source>Test…</source>
        <translation>Testen…</translation>
    </message>
    <message>
        <source>Measure round trip, noise, friction and the stiffness that the device holds</source>
        <translation>Laufzeit, Rauschen, Reibung und die Steifigkeit messen, die das Gerät hält</translation>
    </message>
    <message>
        <source>Check the axes…</source>
        <translation>Achsen prüfen…</translation>
    </message>
    <message>
        <source>Check whether the device moves as the hand does</source>
        <translation>Prüfen, ob sich das Gerät wie die Hand bewegt</translation>
    </message>
    <message>
        <source>Check once whether %1 moves as your hand does.</source>
        <translation>Prüfen Sie einmal, ob sich %1 wie Ihre Hand bewegt.</translation>
    </message>
    <message>
        <source>Hold to press harder, wheel for the force limit; then Mark; right drag turns the view</source>
        <translation>Halten drückt stärker, das Rad stellt die Höchstkraft ein; dann Markieren; Ziehen mit rechts dreht die Ansicht</translation>
    </message>
    <message>
        <source>Drag to press, wheel for depth; then Mark; right drag turns the view</source>
        <translation>Ziehen zum Drücken, Rad für die Tiefe; dann Markieren; Ziehen mit rechts dreht die Ansicht</translation>
    </message>
    <message>
        <source>Palpate (P): hold to press harder, wheel for the force limit</source>
        <translation>Tasten (P): Halten drückt stärker, das Rad stellt die Höchstkraft ein</translation>
    </message>
    <message>
        <source>Palpate (P): drag to press, wheel for depth</source>
        <translation>Tasten (P): Ziehen zum Drücken, Rad für die Tiefe</translation>
    </message>
</context>
<context>
    <name>palpate::app::DistancesPart</name>
    <message>
        <source>Distances and sizes</source>
        <translation>Abstände und Größen</translation>
    </message>
    <message>
        <source>Measure the distances and margins of lumps to other structures, and list the tapes</source>
        <translation>Abstände und Ränder der Knoten zu anderen Strukturen messen und die Maßbänder auflisten</translation>
    </message>
    <message>
        <source>Tape</source>
        <translation>Maßband</translation>
    </message>
    <message>
        <source>Measure between two places: click on both, or touch both and press T each time; snaps to findings</source>
        <translation>Zwischen zwei Orten messen: beide anklicken, oder beide berühren und jedes Mal T drücken; rastet an Befunden ein</translation>
    </message>
    <message>
        <source>Distances</source>
        <translation>Abstände</translation>
    </message>
</context>
<context>
    <name>palpate::app::Docks</name>
    <message>
        <source>Next panel</source>
        <translation>Nächster Bereich</translation>
    </message>
    <message>
        <source>Move the keyboard focus to the next panel, after the last to the view</source>
        <translation>Den Tastaturfokus auf den nächsten Bereich setzen, nach dem letzten auf die Ansicht</translation>
    </message>
    <message>
        <source>Previous panel</source>
        <translation>Voriger Bereich</translation>
    </message>
    <message>
        <source>Move the keyboard focus to the previous panel</source>
        <translation>Den Tastaturfokus auf den vorigen Bereich setzen</translation>
    </message>
    <message>
        <source>Hide or show all panels</source>
        <translation>Alle Bereiche verbergen oder zeigen</translation>
    </message>
    <message>
        <source>Panels</source>
        <translation>Bereiche</translation>
    </message>
</context>
<context>
    <name>palpate::app::DocumentPart</name>
    <message>
        <source>Save scene</source>
        <translation>Szene speichern</translation>
    </message>
    <message>
        <source>Save the scene with its tissue</source>
        <translation>Die Szene mit ihrem Gewebe speichern</translation>
    </message>
    <message>
        <source>Save scene as…</source>
        <translation>Szene speichern unter…</translation>
    </message>
    <message>
        <source>Save the scene with its tissue to another file</source>
        <translation>Die Szene mit ihrem Gewebe in eine andere Datei speichern</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>Rückgängig</translation>
    </message>
    <message>
        <source>Undo the last change</source>
        <translation>Die letzte Änderung rückgängig machen</translation>
    </message>
    <message>
        <source>Redo</source>
        <translation>Wiederholen</translation>
    </message>
    <message>
        <source>Redo the last undone change</source>
        <translation>Die zuletzt rückgängig gemachte Änderung wiederholen</translation>
    </message>
    <message>
        <source>Undo: %1</source>
        <translation>Rückgängig: %1</translation>
    </message>
    <message>
        <source>Redo: %1</source>
        <translation>Wiederholen: %1</translation>
    </message>
    <message>
        <source>The scene was changed elsewhere</source>
        <translation>Die Szene wurde anderswo geändert</translation>
    </message>
    <message>
        <source>Another window or program has saved %1 since it was opened here. Saving would replace that version.</source>
        <translation>Ein anderes Fenster oder Programm hat %1 gespeichert, seit die Szene hier geöffnet wurde. Speichern würde diese Version ersetzen.</translation>
    </message>
    <message>
        <source>Save anyway</source>
        <translation>Trotzdem speichern</translation>
    </message>
    <message>
        <source>Save as…</source>
        <translation>Speichern unter…</translation>
    </message>
    <message>
        <source>Palpate scene (*.palpate.json)</source>
        <translation>Palpate-Szene (*.palpate.json)</translation>
    </message>
    <message>
        <source>Scene saved to %1</source>
        <translation>Szene nach %1 gespeichert</translation>
    </message>
    <message>
        <source>Unsaved changes</source>
        <translation>Ungespeicherte Änderungen</translation>
    </message>
    <message>
        <source>Save the changes to this scene?</source>
        <translation>Die Änderungen an dieser Szene speichern?</translation>
    </message>
    <message>
        <source>Palpate[*]</source>
        <translation>Palpate[*]</translation>
    </message>
    <message>
        <source>Unsaved scene</source>
        <translation>Ungespeicherte Szene</translation>
    </message>
    <message>
        <source>%1 and %2 more</source>
        <translation>%1 und %2 weitere</translation>
    </message>
    <message>
        <source>%1[*] – Palpate</source>
        <translation>%1[*] – Palpate</translation>
    </message>
    <message>
        <source>Palpate ended unexpectedly. Unsaved changes of a scene can be restored.</source>
        <translation>Palpate wurde unerwartet beendet. Ungespeicherte Änderungen einer Szene lassen sich zurückholen.</translation>
    </message>
    <message>
        <source>Restore</source>
        <translation>Zurückholen</translation>
    </message>
    <message>
        <source>These changes were already restored in another window.</source>
        <translation>Diese Änderungen wurden schon in einem anderen Fenster wiederhergestellt.</translation>
    </message>
    <message>
        <source>Unsaved copy of %1</source>
        <translation>Nicht gespeicherte Kopie von %1</translation>
    </message>
</context>
<context>
    <name>palpate::app::EngineeringPart</name>
    <message>
        <source>State of the servo loop</source>
        <translation>Zustand der Servoschleife</translation>
    </message>
    <message>
        <source>Engineering</source>
        <translation>Technik</translation>
    </message>
    <message>
        <source>Show or hide measurements of solver, servo loop and device</source>
        <translation>Messwerte von Löser, Servoschleife und Gerät zeigen oder verbergen</translation>
    </message>
    <message>
        <source>Forces may stutter: %1: %2. %3</source>
        <translation>Kräfte können stocken: %1: %2. %3</translation>
    </message>
</context>
<context>
    <name>palpate::app::ExerciseDialog</name>
    <message>
        <source>Results of the exercise</source>
        <translation>Ergebnisse der Übung</translation>
    </message>
    <message>
        <source>Scoring the recording…</source>
        <translation>Die Aufzeichnung wird ausgewertet…</translation>
    </message>
    <message>
        <source>Result of saving</source>
        <translation>Ergebnis des Speicherns</translation>
    </message>
    <message>
        <source>Save page…</source>
        <translation>Seite speichern…</translation>
    </message>
    <message>
        <source>Save this page with a picture as PDF or web page</source>
        <translation>Diese Seite mit einem Bild als PDF oder Webseite speichern</translation>
    </message>
    <message>
        <source>Save numbers (JSON)…</source>
        <translation>Zahlen speichern (JSON)…</translation>
    </message>
    <message>
        <source>Save the numbers in machine-readable form, as palpate session exercise writes them</source>
        <translation>Die Zahlen in maschinenlesbarer Form speichern, wie palpate session exercise sie schreibt</translation>
    </message>
    <message>
        <source>Do it again</source>
        <translation>Wiederholen</translation>
    </message>
    <message>
        <source>Hide the targets again for another search</source>
        <translation>Die Ziele für eine weitere Suche wieder verbergen</translation>
    </message>
    <message>
        <source>Page of the exercise</source>
        <translation>Seite der Übung</translation>
    </message>
    <message>
        <source>PDF for printing (*.pdf);;Web page, for screen readers too (*.html)</source>
        <translation>PDF zum Drucken (*.pdf);;Webseite, auch für Bildschirmleser (*.html)</translation>
    </message>
    <message>
        <source>Numbers of the exercise</source>
        <translation>Zahlen der Übung</translation>
    </message>
    <message>
        <source>Numbers (*.json)</source>
        <translation>Zahlen (*.json)</translation>
    </message>
    <message>
        <source>Nothing was written: %1 must end in .pdf, .html or .json.</source>
        <translation>Nichts wurde geschrieben: %1 muss auf .pdf, .html oder .json enden.</translation>
    </message>
    <message>
        <source>Written to %1.</source>
        <translation>Nach %1 geschrieben.</translation>
    </message>
</context>
<context>
    <name>palpate::app::ExercisePart</name>
    <message>
        <source>Search for the hidden targets: records the hand until the end</source>
        <translation>Nach den verborgenen Zielen suchen: zeichnet die Hand bis zum Ende auf</translation>
    </message>
    <message>
        <source>Start the exercise</source>
        <translation>Übung beginnen</translation>
    </message>
    <message>
        <source>Show the targets…</source>
        <translation>Ziele zeigen…</translation>
    </message>
    <message>
        <source>Give up the exercise without a search</source>
        <translation>Die Übung ohne Suche aufgeben</translation>
    </message>
    <message>
        <source>Do the exercise again</source>
        <translation>Übung wiederholen</translation>
    </message>
    <message>
        <source>Hide the targets again for another search</source>
        <translation>Die Ziele für eine weitere Suche wieder verbergen</translation>
    </message>
    <message>
        <source>Results of the exercise…</source>
        <translation>Ergebnisse der Übung…</translation>
    </message>
    <message>
        <source>Found and missed targets, time, coverage and force of the last search</source>
        <translation>Gefundene und verfehlte Ziele, Zeit, Abdeckung und Kraft der letzten Suche</translation>
    </message>
    <message>
        <source>End the exercise</source>
        <translation>Übung beenden</translation>
    </message>
    <message>
        <source>Off until the exercise ends, because it could show the hidden targets</source>
        <translation>Aus bis zum Ende der Übung, weil es die verborgenen Ziele zeigen könnte</translation>
    </message>
    <message>
        <source>The recording starts with the exercise (Session menu)</source>
        <translation>Die Aufzeichnung beginnt mit der Übung (Menü Sitzung)</translation>
    </message>
    <message>
        <source>This scene is an exercise: find the hidden targets by touch. Start it in the view or in the Session menu.</source>
        <translation>Diese Szene ist eine Übung: Finden Sie die verborgenen Ziele durch Tasten. Beginnen Sie in der Ansicht oder im Menü Sitzung.</translation>
    </message>
    <message>
        <source>Stop the recording before you start the exercise.</source>
        <translation>Beenden Sie die Aufzeichnung, bevor Sie die Übung beginnen.</translation>
    </message>
    <message>
        <source>Show the targets without a search? Whoever has seen them cannot search for them any more.</source>
        <translation>Die Ziele ohne Suche zeigen? Wer sie gesehen hat, kann sie nicht mehr suchen.</translation>
    </message>
    <message>
        <source>Show the targets</source>
        <translation>Ziele zeigen</translation>
    </message>
    <message>
        <source>Keep them hidden</source>
        <translation>Verborgen lassen</translation>
    </message>
    <message>
        <source>Stop the recording before you do the exercise again.</source>
        <translation>Beenden Sie die Aufzeichnung, bevor Sie die Übung wiederholen.</translation>
    </message>
    <message>
        <source>Time is up.</source>
        <translation>Die Zeit ist um.</translation>
    </message>
    <message>
        <source>%1 · %2</source>
        <translation>%1 · %2</translation>
    </message>
    <message numerus="yes">
        <source>%n hidden target(s)</source>
        <translation>
            <numerusform>%n verborgenes Ziel</numerusform>
            <numerusform>%n verborgene Ziele</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n marked</source>
        <translation>
            <numerusform>%n markiert</numerusform>
            <numerusform>%n markiert</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 left</source>
        <translation>noch %1</translation>
    </message>
    <message>
        <source>%1 N: above the ceiling of %2 N</source>
        <translation>%1 N: über der Grenze von %2 N</translation>
    </message>
    <message>
        <source>%1 N, ceiling %2 N</source>
        <translation>%1 N, Grenze %2 N</translation>
    </message>
    <message numerus="yes">
        <source>Exercise: %n hidden target(s)</source>
        <translation>
            <numerusform>Übung: %n verborgenes Ziel</numerusform>
            <numerusform>Übung: %n verborgene Ziele</numerusform>
        </translation>
    </message>
    <message>
        <source>Force ceiling %1 N</source>
        <translation>Kraftgrenze %1 N</translation>
    </message>
    <message>
        <source>Find them by touch. The search is recorded. Sections, peek, maps, distances, results and reports are off until the end.</source>
        <translation>Finden Sie sie durch Tasten. Die Suche wird aufgezeichnet. Schnitte, Durchblick, Karten, Abstände, Ergebnisse und Berichte sind bis zum Ende aus.</translation>
    </message>
    <message>
        <source>Exercise: the targets are shown</source>
        <translation>Übung: Die Ziele werden gezeigt</translation>
    </message>
    <message>
        <source>%1: found after %2 s</source>
        <translation>%1: nach %2 s gefunden</translation>
    </message>
    <message>
        <source>%1: missed</source>
        <translation>%1: verfehlt</translation>
    </message>
    <message>
        <source>The exercise runs. Mark each place that you find (Mark in the tool bar or M).</source>
        <translation>Die Übung läuft. Markieren Sie jede Stelle, die Sie finden (Markieren in der Werkzeugleiste oder M).</translation>
    </message>
    <message>
        <source>At each place that you find, click Mark or press M.</source>
        <translation>An jeder Stelle, die Sie finden, auf Markieren klicken oder M drücken.</translation>
    </message>
</context>
<context>
    <name>palpate::app::FindingsPart</name>
    <message>
        <source>Import findings…</source>
        <translation>Befunde importieren…</translation>
    </message>
    <message>
        <source>Import the points of a 3D Slicer markups file (.mrk.json) as findings</source>
        <translation>Die Punkte einer Markups-Datei von 3D Slicer (.mrk.json) als Befunde importieren</translation>
    </message>
    <message>
        <source>Export findings…</source>
        <translation>Befunde exportieren…</translation>
    </message>
    <message>
        <source>Export findings and notes as a table (CSV) or as 3D Slicer markups (.mrk.json)</source>
        <translation>Befunde und Notizen als Tabelle (CSV) oder als Markups von 3D Slicer (.mrk.json) exportieren</translation>
    </message>
    <message>
        <source>Findings</source>
        <translation>Befunde</translation>
    </message>
    <message>
        <source>Show the places marked as findings</source>
        <translation>Die als Befund markierten Stellen zeigen</translation>
    </message>
    <message>
        <source>Mark a finding</source>
        <translation>Befund markieren</translation>
    </message>
    <message>
        <source>Mark a finding and write…</source>
        <translation>Befund markieren und schreiben…</translation>
    </message>
    <message>
        <source>Note…</source>
        <translation>Notiz…</translation>
    </message>
    <message>
        <source>Write a note without a place</source>
        <translation>Eine Notiz ohne Stelle schreiben</translation>
    </message>
    <message>
        <source>Next finding</source>
        <translation>Nächster Befund</translation>
    </message>
    <message>
        <source>Go to the next finding and restore the view in which it was marked</source>
        <translation>Zum nächsten Befund, in der Ansicht, in der er markiert wurde</translation>
    </message>
    <message>
        <source>Previous finding</source>
        <translation>Voriger Befund</translation>
    </message>
    <message>
        <source>Go to the previous finding</source>
        <translation>Zum vorigen Befund</translation>
    </message>
    <message>
        <source>Enter  F2  Del</source>
        <translation>Enter  F2  Entf</translation>
    </message>
    <message>
        <source>in the findings: go there, edit, delete</source>
        <translation>in den Befunden: hingehen, bearbeiten, löschen</translation>
    </message>
    <message>
        <source>Shift+Enter</source>
        <translation>Umschalt+Enter</translation>
    </message>
    <message>
        <source>in the findings: play the recording from the marked moment</source>
        <translation>in den Befunden: die Aufzeichnung ab der Markierung abspielen</translation>
    </message>
    <message>
        <source>3D Slicer markups (*.mrk.json)</source>
        <translation>Markups von 3D Slicer (*.mrk.json)</translation>
    </message>
    <message>
        <source>Table (*.csv)</source>
        <translation>Tabelle (*.csv)</translation>
    </message>
    <message>
        <source>Export findings</source>
        <translation>Befunde exportieren</translation>
    </message>
    <message>
        <source>Import findings</source>
        <translation>Befunde importieren</translation>
    </message>
    <message>
        <source>3D Slicer markups (*.mrk.json *.json);;All files (*)</source>
        <translation>Markups von 3D Slicer (*.mrk.json *.json);;Alle Dateien (*)</translation>
    </message>
    <message>
        <source>Mark the touched place, or the place pressed last, in the scene and in the recording</source>
        <translation>Die berührte oder die zuletzt gedrückte Stelle in der Szene und in der Aufzeichnung markieren</translation>
    </message>
    <message>
        <source>Mark</source>
        <translation>Markieren</translation>
    </message>
    <message>
        <source>Mark the touched place, or the place pressed last, and write a note on it</source>
        <translation>Die berührte oder die zuletzt gedrückte Stelle markieren und eine Notiz dazu schreiben</translation>
    </message>
</context>
<context>
    <name>palpate::app::FingertipPart</name>
    <message>
        <source>Ball, radius %1 mm</source>
        <translation>Kugel, Radius %1 mm</translation>
    </message>
    <message>
        <source>Point</source>
        <translation>Punkt</translation>
    </message>
    <message>
        <source>Contact shape: a point feels every facet; a ball slides over small pits like a finger</source>
        <translation>Kontaktform: Ein Punkt spürt jede Facette; eine Kugel gleitet wie ein Finger über kleine Gruben</translation>
    </message>
    <message>
        <source>Fingertip</source>
        <translation>Fingerspitze</translation>
    </message>
    <message>
        <source>fingertip %1 mm ▾</source>
        <translation>Fingerspitze %1 mm ▾</translation>
    </message>
    <message>
        <source>fingertip: point ▾</source>
        <translation>Fingerspitze: Punkt ▾</translation>
    </message>
    <message>
        <source>%1 mm ▾</source>
        <translation>%1 mm ▾</translation>
    </message>
    <message>
        <source>point ▾</source>
        <translation>Punkt ▾</translation>
    </message>
</context>
<context>
    <name>palpate::app::Help</name>
    <message>
        <source>About Palpate</source>
        <translation>Über Palpate</translation>
    </message>
    <message>
        <source>Copied: version, build and system.</source>
        <translation>Kopiert: Version, Build und System.</translation>
    </message>
    <message>
        <source>Documentation</source>
        <translation>Dokumentation</translation>
    </message>
    <message>
        <source>Open the documentation folder: keys, recordings, measures, glossary, devices</source>
        <translation>Den Ordner mit der Dokumentation öffnen: Tasten, Aufzeichnungen, Maße, Glossar, Geräte</translation>
    </message>
    <message>
        <source>Version, build and licences, for bug reports</source>
        <translation>Version, Build und Lizenzen, für Fehlerberichte</translation>
    </message>
    <message>
        <source>The documentation was not found next to the program.</source>
        <translation>Die Dokumentation wurde neben dem Programm nicht gefunden.</translation>
    </message>
    <message>
        <source>No file manager was found. The documentation is in %1</source>
        <translation>Kein Dateimanager gefunden. Die Dokumentation liegt in %1</translation>
    </message>
    <message>
        <source>Research, training and planning rehearsal. Not a medical device.

Palpate is free software under the BSD 3-Clause licence, built with Qt (LGPL 3), VTK (BSD 3-Clause), Eigen (MPL 2.0), SQLite (public domain), hidapi (BSD) and CLI11 (BSD 3-Clause).</source>
        <translation>Für Forschung, Ausbildung und Planungsübung. Kein Medizinprodukt.

Palpate ist freie Software unter der BSD-3-Clause-Lizenz und verwendet Qt (LGPL 3), VTK (BSD 3-Clause), Eigen (MPL 2.0), SQLite (gemeinfrei), hidapi (BSD) und CLI11 (BSD 3-Clause).</translation>
    </message>
    <message>
        <source>Copy for a bug report</source>
        <translation>Für einen Fehlerbericht kopieren</translation>
    </message>
</context>
<context>
    <name>palpate::app::HelpPart</name>
    <message>
        <source>All keys</source>
        <translation>Alle Tasten</translation>
    </message>
    <message>
        <source>Show all keys</source>
        <translation>Alle Tasten zeigen</translation>
    </message>
    <message>
        <source>Single-letter keys</source>
        <translation>Tasten mit Buchstaben</translation>
    </message>
    <message>
        <source>Run commands by single letters. Turn this off for speech input, or if keys are pressed by accident</source>
        <translation>Befehle mit einzelnen Buchstaben ausführen. Für Spracheingabe ausschalten, oder wenn Tasten versehentlich gedrückt werden</translation>
    </message>
</context>
<context>
    <name>palpate::app::ImagePart</name>
    <message>
        <source>Show an image…</source>
        <translation>Bild zeigen…</translation>
    </message>
    <message>
        <source>Show a CT, MR or ultrasound volume in sections</source>
        <translation>Ein CT-, MR- oder Ultraschallvolumen in Schnitten zeigen</translation>
    </message>
    <message>
        <source>Remove the image</source>
        <translation>Bild entfernen</translation>
    </message>
    <message>
        <source>Show sections without the image; the file is kept</source>
        <translation>Schnitte ohne das Bild zeigen; die Datei bleibt</translation>
    </message>
    <message>
        <source>Show an image</source>
        <translation>Bild zeigen</translation>
    </message>
    <message>
        <source>Images (%1);;All files (*)</source>
        <translation>Bilder (%1);;Alle Dateien (*)</translation>
    </message>
    <message>
        <source>Reading %1…</source>
        <translation>%1 wird gelesen…</translation>
    </message>
    <message>
        <source>%1 is shown in sections (X).</source>
        <translation>%1 wird in Schnitten gezeigt (X).</translation>
    </message>
    <message>
        <source>%1 lies beside all structures. Do the axes and units of image and meshes agree?</source>
        <translation>%1 liegt neben allen Strukturen. Passen Achsen und Einheiten von Bild und Netzen zusammen?</translation>
    </message>
</context>
<context>
    <name>palpate::app::Language</name>
    <message>
        <source>Language</source>
        <translation>Sprache</translation>
    </message>
    <message>
        <source>The new language takes effect when Palpate is restarted.</source>
        <translation>Die neue Sprache gilt nach einem Neustart von Palpate.</translation>
    </message>
    <message>
        <source>Same as system</source>
        <translation>Wie das System</translation>
    </message>
</context>
<context>
    <name>palpate::app::LayerOffers</name>
    <message>
        <source>%1; %2 more are listed in the panel.</source>
        <translation>%1; %2 weitere stehen im Bereich.</translation>
    </message>
    <message>
        <source>Feel inner structures below outer ones</source>
        <translation>Innere Strukturen unter äußeren fühlen</translation>
    </message>
    <message>
        <source>Feel it as a layer</source>
        <translation>Als Schicht fühlen</translation>
    </message>
    <message>
        <source>All in one layer</source>
        <translation>Alles in einer Schicht</translation>
    </message>
    <message>
        <source>Feel all in one layer</source>
        <translation>Alles in einer Schicht fühlen</translation>
    </message>
    <message>
        <source>%1 lies in %2, but all structures of this scene are in one layer: %1 cannot be felt through %2.</source>
        <translation>%1 liegt in %2, aber alle Strukturen dieser Szene liegen in einer Schicht: durch %2 hindurch ist %1 nicht zu fühlen.</translation>
    </message>
    <message>
        <source>Feel it below</source>
        <translation>Darunter fühlen</translation>
    </message>
    <message>
        <source>Added structures lie in or around others. The existing layers were kept.</source>
        <translation>Hinzugefügte Strukturen liegen in oder um andere. Die vorhandenen Schichten wurden beibehalten.</translation>
    </message>
    <message>
        <source>%1 cannot be felt through %2 yet: %3</source>
        <translation>%1 ist durch %2 noch nicht zu fühlen: %3</translation>
    </message>
    <message>
        <source>Feel it as a layer below</source>
        <translation>Als Schicht darunter fühlen</translation>
    </message>
    <message>
        <source>Feel them as layers below</source>
        <translation>Als Schichten darunter fühlen</translation>
    </message>
    <message>
        <source>Close the holes</source>
        <translation>Löcher schließen</translation>
    </message>
</context>
<context>
    <name>palpate::app::LegendPart</name>
    <message>
        <source>View › Colour legend shows the legend again.</source>
        <translation>Ansicht › Farblegende zeigt die Legende wieder.</translation>
    </message>
    <message>
        <source>Colour legend</source>
        <translation>Farblegende</translation>
    </message>
    <message>
        <source>Show the legend</source>
        <translation>Legende zeigen</translation>
    </message>
    <message>
        <source>Show what the colours in the view mean</source>
        <translation>Zeigen, was die Farben in der Ansicht bedeuten</translation>
    </message>
    <message>
        <source>Place of the legend; the mouse can drag it there as well</source>
        <translation>Platz der Legende; auch die Maus kann sie dorthin ziehen</translation>
    </message>
    <message>
        <source>Where it hides the least</source>
        <translation>Wo sie am wenigsten verdeckt</translation>
    </message>
    <message>
        <source>Upper left</source>
        <translation>Oben links</translation>
    </message>
    <message>
        <source>Upper right</source>
        <translation>Oben rechts</translation>
    </message>
    <message>
        <source>Lower left</source>
        <translation>Unten links</translation>
    </message>
    <message>
        <source>Lower right</source>
        <translation>Unten rechts</translation>
    </message>
</context>
<context>
    <name>palpate::app::LumpsPart</name>
    <message>
        <source>What can be felt here</source>
        <translation>Was hier tastbar ist</translation>
    </message>
    <message>
        <source>Colour organs by the palpability of the lumps below, with a table</source>
        <translation>Organe nach der Tastbarkeit der Knoten darunter färben, mit einer Tabelle</translation>
    </message>
    <message>
        <source>What can be felt</source>
        <translation>Was tastbar ist</translation>
    </message>
    <message>
        <source>Preparing for touch</source>
        <translation>Tasten wird vorbereitet</translation>
    </message>
</context>
<context>
    <name>palpate::app::MotionPart</name>
    <message>
        <source>Motion</source>
        <translation>Bewegung</translation>
    </message>
    <message>
        <source>Show or hide the controls of moving tissue</source>
        <translation>Die Bedienung bewegten Gewebes zeigen oder verbergen</translation>
    </message>
    <message>
        <source>Hold breath</source>
        <translation>Atem anhalten</translation>
    </message>
    <message>
        <source>Hold breathing tissue where it is</source>
        <translation>Atmendes Gewebe anhalten, wo es ist</translation>
    </message>
</context>
<context>
    <name>palpate::app::Notices</name>
    <message>
        <source>Messages</source>
        <translation>Meldungen</translation>
    </message>
    <message>
        <source>Show or hide the list of all messages and file notes since the start</source>
        <translation>Die Liste aller Meldungen und Hinweise zu Dateien seit dem Start zeigen oder verbergen</translation>
    </message>
</context>
<context>
    <name>palpate::app::PeekPart</name>
    <message>
        <source>Peek inside</source>
        <translation>Hineinsehen</translation>
    </message>
    <message>
        <source>Make everything above the touched structure, or else the selected one, nearly transparent; or hold G</source>
        <translation>Alles über der berührten, sonst der ausgewählten Struktur fast durchsichtig machen; oder G halten</translation>
    </message>
    <message>
        <source>hold G</source>
        <translation>G halten</translation>
    </message>
    <message>
        <source>look through what is above the structure</source>
        <translation>durch das hindurchsehen, was über der Struktur liegt</translation>
    </message>
    <message>
        <source>Peek: touch or select the structure that you want to see.</source>
        <translation>Hineinsehen: Berühren oder wählen Sie die Struktur, die Sie sehen möchten.</translation>
    </message>
    <message>
        <source>Peek: nothing is above %1.</source>
        <translation>Hineinsehen: Über %1 liegt nichts.</translation>
    </message>
</context>
<context>
    <name>palpate::app::PicturePart</name>
    <message>
        <source>Snapshot</source>
        <translation>Foto</translation>
    </message>
    <message>
        <source>Fit</source>
        <translation>Einpassen</translation>
    </message>
    <message>
        <source>Fit everything into the view</source>
        <translation>Alles in die Ansicht einpassen</translation>
    </message>
    <message>
        <source>%1: the picture could not be written. Is the folder writable and the disk not full?</source>
        <translation>%1: das Bild konnte nicht geschrieben werden. Ist der Ordner beschreibbar und der Datenträger nicht voll?</translation>
    </message>
    <message>
        <source>Save a picture of the view with a caption, and copy it</source>
        <translation>Ein Bild der Ansicht mit Bildunterschrift speichern und kopieren</translation>
    </message>
    <message>
        <source>Picture copied, and saved to %1</source>
        <translation>Bild kopiert und gespeichert unter %1</translation>
    </message>
    <message>
        <source>Standard views</source>
        <translation>Standardansichten</translation>
    </message>
</context>
<context>
    <name>palpate::app::ReceivedSurfaces</name>
    <message>
        <source>Surface</source>
        <translation>Fläche</translation>
    </message>
    <message>
        <source>A surface was not received: several others are still being stored. Send it again.</source>
        <translation>Eine Fläche wurde nicht empfangen: Mehrere andere werden noch gespeichert. Senden Sie sie noch einmal.</translation>
    </message>
    <message>
        <source>%1 surfaces were received. Further ones are ignored until Palpate is started again.</source>
        <translation>%1 Flächen wurden empfangen. Weitere werden bis zum nächsten Start von Palpate nicht beachtet.</translation>
    </message>
</context>
<context>
    <name>palpate::app::RecordingPart</name>
    <message>
        <source>Recording</source>
        <translation>Aufzeichnung</translation>
    </message>
    <message>
        <source>Record</source>
        <translation>Aufnehmen</translation>
    </message>
    <message>
        <source>Record the motion and the force of the hand</source>
        <translation>Bewegung und Kraft der Hand aufzeichnen</translation>
    </message>
    <message>
        <source>Play</source>
        <translation>Abspielen</translation>
    </message>
    <message>
        <source>Play or pause the recording</source>
        <translation>Die Aufzeichnung abspielen oder anhalten</translation>
    </message>
    <message>
        <source>To the start</source>
        <translation>Zum Anfang</translation>
    </message>
    <message>
        <source>Return to the start of the recording</source>
        <translation>Zurück zum Anfang der Aufzeichnung</translation>
    </message>
    <message>
        <source>Session</source>
        <translation>Sitzung</translation>
    </message>
    <message>
        <source>Pause</source>
        <translation>Pause</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>Stopp</translation>
    </message>
    <message>
        <source>Recording %1</source>
        <translation>Aufzeichnung %1</translation>
    </message>
    <message>
        <source>Recorded to %1</source>
        <translation>Nach %1 aufgezeichnet</translation>
    </message>
    <message>
        <source>Results…</source>
        <translation>Ergebnisse…</translation>
    </message>
    <message>
        <source>Open the recording</source>
        <translation>Aufzeichnung öffnen</translation>
    </message>
    <message>
        <source>The fingertip is a ball of %1 mm radius, as in the recording (Session › Fingertip).</source>
        <translation>Die Fingerspitze ist wie in der Aufzeichnung eine Kugel mit %1 mm Radius (Sitzung › Fingerspitze).</translation>
    </message>
    <message>
        <source>The fingertip is a point, as in the recording (Session › Fingertip).</source>
        <translation>Die Fingerspitze ist wie in der Aufzeichnung ein Punkt (Sitzung › Fingerspitze).</translation>
    </message>
    <message>
        <source>Find the meshes…</source>
        <translation>Netze suchen…</translation>
    </message>
    <message>
        <source>Meshes of the recording</source>
        <translation>Netze der Aufnahme</translation>
    </message>
    <message>
        <source>Record to another folder…</source>
        <translation>In einen anderen Ordner aufnehmen…</translation>
    </message>
    <message>
        <source>Folder of recordings</source>
        <translation>Ordner der Aufnahmen</translation>
    </message>
    <message>
        <source>Palpate ended unexpectedly while recording %1. The first %2 s were saved.</source>
        <translation>Palpate endete unerwartet während der Aufnahme %1. Die ersten %2 s sind gespeichert.</translation>
    </message>
    <message>
        <source>Do not offer again</source>
        <translation>Nicht mehr anbieten</translation>
    </message>
    <message>
        <source>%1: a recording names what was touched. Open it after the exercise.</source>
        <translation>%1: Eine Aufzeichnung benennt, was berührt wurde. Öffnen Sie sie nach der Übung.</translation>
    </message>
    <message>
        <source>%1 can be played, but its meshes were not found: only the path of the hand is shown. Open the meshes to see what was touched.</source>
        <translation>%1 kann abgespielt werden, aber die Netze wurden nicht gefunden: Nur der Weg der Hand wird gezeigt. Öffnen Sie die Netze, um zu sehen, was berührt wurde.</translation>
    </message>
</context>
<context>
    <name>palpate::app::ReportDialog</name>
    <message>
        <source>Report</source>
        <translation>Bericht</translation>
    </message>
    <message>
        <source>The report contains views, findings, lumps, distances and the force of the open recording. Both fields may stay empty.</source>
        <translation>Der Bericht enthält Ansichten, Befunde, Knoten, Abstände und die Kraft der geöffneten Aufzeichnung. Beide Felder dürfen leer bleiben.</translation>
    </message>
    <message>
        <source>Write report…</source>
        <translation>Bericht schreiben…</translation>
    </message>
    <message>
        <source>&amp;Case</source>
        <translation>&amp;Fall</translation>
    </message>
    <message>
        <source>&amp;Examiner</source>
        <translation>&amp;Untersucher</translation>
    </message>
</context>
<context>
    <name>palpate::app::ReportPart</name>
    <message>
        <source>Report…</source>
        <translation>Bericht…</translation>
    </message>
    <message>
        <source>Write a report of the recording as PDF or web page</source>
        <translation>Einen Bericht der Aufzeichnung als PDF oder Webseite schreiben</translation>
    </message>
    <message>
        <source>PDF for printing (*.pdf)</source>
        <translation>PDF zum Drucken (*.pdf)</translation>
    </message>
    <message>
        <source>Web page, for screen readers too (*.html)</source>
        <translation>Webseite, auch für Bildschirmleser (*.html)</translation>
    </message>
    <message>
        <source>Report</source>
        <translation>Bericht</translation>
    </message>
    <message>
        <source>Nothing was written: %1 already exists. Enter the full file name to replace the file.</source>
        <translation>Nichts wurde geschrieben: %1 ist schon vorhanden. Zum Ersetzen den vollständigen Dateinamen eingeben.</translation>
    </message>
    <message>
        <source>Nothing was written: %1 must end in .pdf or .html.</source>
        <translation>Es wurde nichts geschrieben: %1 muss auf .pdf oder .html enden.</translation>
    </message>
    <message>
        <source>Report written to %1</source>
        <translation>Bericht nach %1 geschrieben</translation>
    </message>
    <message>
        <source>Report cancelled</source>
        <translation>Bericht abgebrochen</translation>
    </message>
    <message>
        <source>Report written to %1; it lists the missing parts</source>
        <translation>Bericht nach %1 geschrieben; er nennt, was fehlt</translation>
    </message>
    <message>
        <source>The report describes a finished recording.</source>
        <translation>Der Bericht beschreibt eine beendete Aufzeichnung.</translation>
    </message>
    <message>
        <source>Stop and report…</source>
        <translation>Beenden und berichten…</translation>
    </message>
    <message>
        <source>The report describes a recording: record, press, mark findings and stop. Then choose Report again.</source>
        <translation>Der Bericht beschreibt eine Aufzeichnung: aufnehmen, drücken, Befunde markieren und beenden. Dann erneut Bericht wählen.</translation>
    </message>
    <message>
        <source>Record</source>
        <translation>Aufnehmen</translation>
    </message>
    <message>
        <source>Open the report</source>
        <translation>Bericht öffnen</translation>
    </message>
    <message>
        <source>No program was found that opens %1.</source>
        <translation>Es wurde kein Programm gefunden, das %1 öffnet.</translation>
    </message>
    <message numerus="yes">
        <source>Report written to %1; %n finding(s) marked outside of the recording are in a table of their own</source>
        <translation>
            <numerusform>Bericht nach %1 geschrieben; %n außerhalb der Aufzeichnung markierter Befund steht in einer eigenen Tabelle</numerusform>
            <numerusform>Bericht nach %1 geschrieben; %n außerhalb der Aufzeichnung markierte Befunde stehen in einer eigenen Tabelle</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>palpate::app::ReportRun</name>
    <message>
        <source>Report</source>
        <translation>Bericht</translation>
    </message>
</context>
<context>
    <name>palpate::app::ResultsPart</name>
    <message>
        <source>Results…</source>
        <translation>Ergebnisse…</translation>
    </message>
    <message>
        <source>Show and export forces, coverage and findings of the recording</source>
        <translation>Kräfte, Abdeckung und Befunde der Aufzeichnung zeigen und exportieren</translation>
    </message>
    <message>
        <source>Store the surfaces in recordings</source>
        <translation>Oberflächen in Aufzeichnungen mitspeichern</translation>
    </message>
    <message>
        <source>A recording then contains the whole session and grows by the size of the meshes</source>
        <translation>Eine Aufzeichnung enthält dann die ganze Sitzung und wächst um die Größe der Netze</translation>
    </message>
</context>
<context>
    <name>palpate::app::SceneChanges</name>
    <message>
        <source>1 note on these files</source>
        <translation>1 Hinweis zu diesen Dateien</translation>
    </message>
    <message>
        <source>%1 notes on these files</source>
        <translation>%1 Hinweise zu diesen Dateien</translation>
    </message>
    <message>
        <source>%1  ·  %2 (F4 lists them)</source>
        <translation>%1  ·  %2 (F4 zeigt sie)</translation>
    </message>
    <message>
        <source>The meshes were read again with coordinates %1. Tissue and findings are kept; earlier changes cannot be undone.</source>
        <translation>Die Netze wurden mit Koordinaten %1 neu gelesen. Gewebe und Befunde bleiben; frühere Änderungen lassen sich nicht rückgängig machen.</translation>
    </message>
    <message>
        <source>%1: %2 (%3)</source>
        <translation>%1: %2 (%3)</translation>
    </message>
    <message>
        <source>%1 was added to the scene.</source>
        <translation>%1 wurde zur Szene hinzugefügt.</translation>
    </message>
    <message>
        <source>%1 structures were added to the scene.</source>
        <translation>%1 Strukturen wurden zur Szene hinzugefügt.</translation>
    </message>
    <message>
        <source>Add %1</source>
        <translation>%1 hinzufügen</translation>
    </message>
    <message>
        <source>Add %1 structures</source>
        <translation>%1 Strukturen hinzufügen</translation>
    </message>
    <message>
        <source>%1 structures: %2 (%3 and others; the sign in the list of structures has the details)</source>
        <translation>%1 Strukturen: %2 (%3 und andere; Einzelheiten am Zeichen in der Liste der Strukturen)</translation>
    </message>
    <message>
        <source>The scene has an exercise. Its targets are shown, because a recording is opened.</source>
        <translation>Die Szene hat eine Übung. Ihre Ziele werden gezeigt, weil eine Aufzeichnung geöffnet wird.</translation>
    </message>
    <message numerus="yes">
        <source>%n note(s) on hidden targets are withheld</source>
        <translation>
            <numerusform>%n Hinweis zu verborgenen Zielen wird zurückgehalten</numerusform>
            <numerusform>%n Hinweise zu verborgenen Zielen werden zurückgehalten</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>palpate::app::SceneFiles</name>
    <message>
        <source>Opening was cancelled.</source>
        <translation>Das Öffnen wurde abgebrochen.</translation>
    </message>
    <message>
        <source>Open…</source>
        <translation>Öffnen…</translation>
    </message>
    <message>
        <source>Open meshes, a scene or a recording</source>
        <translation>Netze, eine Szene oder eine Aufzeichnung öffnen</translation>
    </message>
    <message>
        <source>Add to the scene…</source>
        <translation>Zur Szene hinzufügen…</translation>
    </message>
    <message>
        <source>Add meshes or a scene to the open scene</source>
        <translation>Netze oder eine Szene zur offenen Szene hinzufügen</translation>
    </message>
    <message>
        <source>Close the scene</source>
        <translation>Szene schließen</translation>
    </message>
    <message>
        <source>Close the open scene</source>
        <translation>Die offene Szene schließen</translation>
    </message>
    <message>
        <source>%1 files</source>
        <translation>%1 Dateien</translation>
    </message>
    <message>
        <source>Add %1 to the open scene?</source>
        <translation>%1 zur offenen Szene hinzufügen?</translation>
    </message>
    <message>
        <source>Add</source>
        <translation>Hinzufügen</translation>
    </message>
    <message>
        <source>Open instead</source>
        <translation>Allein öffnen</translation>
    </message>
    <message>
        <source>The phantom was not found next to the program.</source>
        <translation>Das Phantom wurde neben dem Programm nicht gefunden.</translation>
    </message>
    <message>
        <source>This anatomy is only %1 mm across. Its coordinates are probably in metres.</source>
        <translation>Diese Anatomie ist nur %1 mm groß. Ihre Koordinaten sind vermutlich in Metern.</translation>
    </message>
    <message>
        <source>Read as metres</source>
        <translation>Als Meter lesen</translation>
    </message>
    <message>
        <source>Open anatomy</source>
        <translation>Anatomie öffnen</translation>
    </message>
    <message>
        <source>Anatomy, scenes and recordings (%1);;All files (*)</source>
        <translation>Anatomie, Szenen und Aufzeichnungen (%1);;Alle Dateien (*)</translation>
    </message>
    <message>
        <source>Add to the scene</source>
        <translation>Zur Szene hinzufügen</translation>
    </message>
    <message>
        <source>%1 has points of 3D Slicer, which become findings. Open the anatomy first, or both at once.</source>
        <translation>%1 enthält Punkte von 3D Slicer, die zu Befunden werden. Öffnen Sie zuerst die Anatomie, oder beides zugleich.</translation>
    </message>
    <message>
        <source>%1: is it an image of the open scene, or a segmentation?</source>
        <translation>%1: Ist das ein Bild der offenen Szene oder eine Segmentierung?</translation>
    </message>
    <message>
        <source>Show the image</source>
        <translation>Bild zeigen</translation>
    </message>
    <message>
        <source>Open the segmentation</source>
        <translation>Segmentierung öffnen</translation>
    </message>
    <message>
        <source>Some of the files are cut off.</source>
        <translation>Einige der Dateien sind abgeschnitten.</translation>
    </message>
    <message>
        <source>Open the part that is there</source>
        <translation>Den vorhandenen Teil öffnen</translation>
    </message>
</context>
<context>
    <name>palpate::app::SceneSurfaces</name>
    <message>
        <source>Computing the surface of %1…</source>
        <translation>Oberfläche von %1 wird berechnet…</translation>
    </message>
    <message>
        <source>The map of %1 was applied.</source>
        <translation>Die Karte von %1 wurde angewendet.</translation>
    </message>
    <message>
        <source>Reading the maps of %1…</source>
        <translation>Karten von %1 werden gelesen…</translation>
    </message>
    <message>
        <source>The surface of %1 was replaced.</source>
        <translation>Die Oberfläche von %1 wurde ersetzt.</translation>
    </message>
    <message>
        <source>%1 × %2 × %3 mm</source>
        <translation>%1 × %2 × %3 mm</translation>
    </message>
    <message>
        <source>%1 has voxel steps of about %2, which can be felt.</source>
        <translation>%1 hat Voxelstufen von etwa %2, die zu spüren sind.</translation>
    </message>
    <message>
        <source>%1 surfaces have voxel steps of about %2, which can be felt.</source>
        <translation>%1 Oberflächen haben Voxelstufen von etwa %2, die zu spüren sind.</translation>
    </message>
    <message>
        <source>Smooth it</source>
        <translation>Glätten</translation>
    </message>
    <message>
        <source>Smooth them</source>
        <translation>Alle glätten</translation>
    </message>
    <message>
        <source>%1 is inside out: it can be felt only from inside.</source>
        <translation>%1 ist umgestülpt und nur von innen zu spüren.</translation>
    </message>
    <message>
        <source>%1 surfaces are inside out: they can be felt only from inside.</source>
        <translation>%1 Oberflächen sind umgestülpt und nur von innen zu spüren.</translation>
    </message>
    <message>
        <source>Turn it around</source>
        <translation>Umdrehen</translation>
    </message>
    <message>
        <source>Turn them around</source>
        <translation>Alle umdrehen</translation>
    </message>
</context>
<context>
    <name>palpate::app::SectionPart</name>
    <message>
        <source>axial, %1 mm superior</source>
        <translation>axial, %1 mm kranial</translation>
    </message>
    <message>
        <source>axial, %1 mm inferior</source>
        <translation>axial, %1 mm kaudal</translation>
    </message>
    <message>
        <source>coronal, %1 mm posterior</source>
        <translation>koronal, %1 mm posterior</translation>
    </message>
    <message>
        <source>coronal, %1 mm anterior</source>
        <translation>koronal, %1 mm anterior</translation>
    </message>
    <message>
        <source>sagittal, %1 mm left</source>
        <translation>sagittal, %1 mm links</translation>
    </message>
    <message>
        <source>sagittal, %1 mm right</source>
        <translation>sagittal, %1 mm rechts</translation>
    </message>
    <message>
        <source>free, %1 mm deeper</source>
        <translation>frei, %1 mm tiefer</translation>
    </message>
    <message>
        <source>free, %1 mm nearer</source>
        <translation>frei, %1 mm näher</translation>
    </message>
    <message>
        <source>Section</source>
        <translation>Schnitt</translation>
    </message>
    <message>
        <source>Cut the picture through the hand, the selected finding or the middle of the view; the hand still feels everything</source>
        <translation>Das Bild durch die Hand, den ausgewählten Befund oder die Mitte der Ansicht schneiden; die Hand fühlt weiterhin alles</translation>
    </message>
    <message>
        <source>Next direction of the section</source>
        <translation>Nächste Richtung des Schnitts</translation>
    </message>
    <message>
        <source>Axial, coronal, sagittal, or facing the viewer</source>
        <translation>Axial, koronal, sagittal oder zum Betrachter</translation>
    </message>
    <message>
        <source>Other side of the section</source>
        <translation>Andere Seite des Schnitts</translation>
    </message>
    <message>
        <source>Show the side that is hidden</source>
        <translation>Die verdeckte Seite zeigen</translation>
    </message>
    <message>
        <source>Section through the hand</source>
        <translation>Schnitt durch die Hand</translation>
    </message>
    <message>
        <source>Move the section to the hand, the selected finding or the middle of the view</source>
        <translation>Den Schnitt zur Hand, zum ausgewählten Befund oder zur Mitte der Ansicht bewegen</translation>
    </message>
    <message>
        <source>Section deeper</source>
        <translation>Schnitt tiefer</translation>
    </message>
    <message>
        <source>Move the section away from the viewer</source>
        <translation>Den Schnitt vom Betrachter weg bewegen</translation>
    </message>
    <message>
        <source>Section nearer</source>
        <translation>Schnitt näher</translation>
    </message>
    <message>
        <source>Move the section towards the viewer</source>
        <translation>Den Schnitt zum Betrachter hin bewegen</translation>
    </message>
    <message>
        <source>Shift+wheel</source>
        <translation>Umschalt+Rad</translation>
    </message>
    <message>
        <source>move the section</source>
        <translation>den Schnitt bewegen</translation>
    </message>
    <message>
        <source>%1 · cuts no visible structure</source>
        <translation>%1 · schneidet keine sichtbare Struktur</translation>
    </message>
    <message>
        <source>%1 · the hand still feels everything</source>
        <translation>%1 · die Hand fühlt weiterhin alles</translation>
    </message>
    <message>
        <source>Section along the finger</source>
        <translation>Schnitt entlang des Fingers</translation>
    </message>
    <message>
        <source>Small picture of the hand and of what lies below, live and in playback</source>
        <translation>Kleines Bild der Hand und dessen, was darunter liegt, live und bei der Wiedergabe</translation>
    </message>
    <message>
        <source>Section plane</source>
        <translation>Schnittebene</translation>
    </message>
</context>
<context>
    <name>palpate::app::SelfTestDialog</name>
    <message>
        <source>Device test</source>
        <translation>Gerätetest</translation>
    </message>
    <message>
        <source>For about one minute, small forces move the handle, and virtual walls of rising stiffness press against your hand with up to %1 N. The test measures round trip, noise, friction and the stiffness that %2 holds without vibrating. Clear the space around the handle. You can stop the test at any time; the wall is withdrawn at the first sign of instability.</source>
        <translation>Etwa eine Minute lang bewegen kleine Kräfte den Griff, und virtuelle Wände steigender Steifigkeit drücken mit bis zu %1 N gegen Ihre Hand. Der Test misst Laufzeit, Rauschen, Reibung und die Steifigkeit, die %2 ohne Vibrieren hält. Halten Sie den Raum um den Griff frei. Sie können den Test jederzeit abbrechen; beim ersten Zeichen von Instabilität wird die Wand zurückgezogen.</translation>
    </message>
    <message>
        <source>Progress of the test</source>
        <translation>Fortschritt des Tests</translation>
    </message>
    <message>
        <source>Start the test</source>
        <translation>Test starten</translation>
    </message>
    <message>
        <source>Save the page…</source>
        <translation>Seite speichern…</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Folder for the page</source>
        <translation>Ordner für die Seite</translation>
    </message>
</context>
<context>
    <name>palpate::app::ShareDialog</name>
    <message>
        <source>Not encrypted and without a password: everyone in this network can read the touch and the findings.</source>
        <translation>Unverschlüsselt und ohne Passwort: Jeder in diesem Netz kann die Berührung und die Befunde mitlesen.</translation>
    </message>
    <message>
        <source>&amp;Add surfaces that 3D Slicer sends to the scene</source>
        <translation>Von 3D Slicer gesendete Flächen der Szene &amp;hinzufügen</translation>
    </message>
    <message>
        <source>Share with 3D Slicer</source>
        <translation>Mit 3D Slicer teilen</translation>
    </message>
    <message>
        <source>This computer only</source>
        <translation>Nur dieser Rechner</translation>
    </message>
    <message>
        <source>All computers in the network</source>
        <translation>Alle Rechner im Netz</translation>
    </message>
    <message>
        <source>Stored in %1, for this user only</source>
        <translation>Gespeichert in %1, nur für diesen Benutzer</translation>
    </message>
    <message>
        <source>Start sharing</source>
        <translation>Teilen beginnen</translation>
    </message>
    <message>
        <source>Sends the hand, the touched point, the force and the findings by OpenIGTLink. In 3D Slicer, open the module OpenIGTLinkIF, add a connector of type Client with this port and the host name localhost (on another computer: the address of this one), and activate it.</source>
        <translation>Sendet Hand, berührten Punkt, Kraft und Befunde mit OpenIGTLink. Öffnen Sie in 3D Slicer das Modul OpenIGTLinkIF, fügen Sie einen Connector vom Typ Client mit diesem Port und dem Hostnamen localhost (auf einem anderen Rechner: der Adresse von diesem) hinzu und aktivieren Sie ihn.</translation>
    </message>
    <message>
        <source>&amp;Reachable from</source>
        <translation>&amp;Erreichbar von</translation>
    </message>
    <message>
        <source>&amp;Port</source>
        <translation>&amp;Port</translation>
    </message>
    <message>
        <source>Stop sharing</source>
        <translation>Teilen beenden</translation>
    </message>
    <message>
        <source>Not shared.</source>
        <translation>Nicht geteilt.</translation>
    </message>
    <message>
        <source>Waiting for 3D Slicer at port %1.</source>
        <translation>Warten auf 3D Slicer an Port %1.</translation>
    </message>
    <message>
        <source>Connected: %1</source>
        <translation>Verbunden: %1</translation>
    </message>
    <message>
        <source>%1 messages a second</source>
        <translation>%1 Nachrichten pro Sekunde</translation>
    </message>
    <message numerus="yes">
        <source>%n message(s) not sent, because the receiver is too slow</source>
        <translation>
            <numerusform>%n Nachricht nicht gesendet, weil der Empfänger zu langsam ist</numerusform>
            <numerusform>%n Nachrichten nicht gesendet, weil der Empfänger zu langsam ist</numerusform>
        </translation>
    </message>
    <message>
        <source>Latest error: %1</source>
        <translation>Letzter Fehler: %1</translation>
    </message>
</context>
<context>
    <name>palpate::app::SharePart</name>
    <message>
        <source>Sharing</source>
        <translation>Teilen</translation>
    </message>
    <message>
        <source>Share with 3D Slicer…</source>
        <translation>Mit 3D Slicer teilen…</translation>
    </message>
    <message>
        <source>Send the touch and the findings to 3D Slicer and receive surfaces, by OpenIGTLink</source>
        <translation>Berührung und Befunde an 3D Slicer senden und Flächen empfangen, mit OpenIGTLink</translation>
    </message>
    <message>
        <source>sharing</source>
        <translation>wird geteilt</translation>
    </message>
    <message>
        <source>shared with 3D Slicer</source>
        <translation>mit 3D Slicer geteilt</translation>
    </message>
    <message>
        <source>OpenIGTLink server at port %1. To stop it: Device › Share with 3D Slicer…</source>
        <translation>OpenIGTLink-Server an Port %1. Zum Beenden: Gerät › Mit 3D Slicer teilen…</translation>
    </message>
    <message>
        <source>%1 was received from 3D Slicer.</source>
        <translation>%1 wurde von 3D Slicer empfangen.</translation>
    </message>
</context>
<context>
    <name>palpate::app::ShowAround</name>
    <message>
        <source>Show me around</source>
        <translation>Kurzer Rundgang</translation>
    </message>
    <message>
        <source>This is a practice liver with lumps inside.</source>
        <translation>Dies ist eine Übungsleber mit Knoten darin.</translation>
    </message>
    <message>
        <source>Structures</source>
        <translation>Strukturen</translation>
    </message>
    <message>
        <source>Press to feel</source>
        <translation>Drücken und tasten</translation>
    </message>
    <message>
        <source>Touch</source>
        <translation>Berührung</translation>
    </message>
    <message>
        <source>Short tour of the window, with the practice liver if no scene is open</source>
        <translation>Kurzer Rundgang durch das Fenster, an der Übungsleber, wenn keine Szene geöffnet ist</translation>
    </message>
    <message>
        <source>The tour uses the open scene and changes nothing.</source>
        <translation>Der Rundgang nutzt die geöffnete Szene und ändert nichts.</translation>
    </message>
    <message>
        <source>The list shows all structures. The eye shows or hides a structure; the hand makes a structure palpable or not. Below the list you set how the structure feels.</source>
        <translation>Die Liste enthält alle Strukturen. Das Auge zeigt oder verbirgt eine Struktur; die Hand macht sie tastbar oder nicht. Unter der Liste wird eingestellt, wie sie sich anfühlt.</translation>
    </message>
    <message>
        <source>Force in newtons, touched structure, depth in millimetres and a chart of the last ten seconds. At the same depth, stiffer tissue pushes back harder.</source>
        <translation>Kraft in Newton, berührte Struktur, Tiefe in Millimetern und ein Diagramm der letzten zehn Sekunden. Bei gleicher Tiefe drückt steiferes Gewebe stärker zurück.</translation>
    </message>
    <message>
        <source>Recording and findings</source>
        <translation>Aufzeichnung und Befunde</translation>
    </message>
    <message>
        <source>Click Palpate (P), then drag on the anatomy to press and slide; the wheel sets the depth. With the keyboard: Ctrl and the arrow keys move the press point, Enter presses, Page Down goes deeper. Esc releases.</source>
        <translation>Auf Tasten (P) klicken, dann auf der Anatomie ziehen, um zu drücken und zu gleiten; das Rad stellt die Tiefe. Mit der Tastatur: Strg und die Pfeiltasten verschieben die Druckstelle, Eingabe drückt, Bild ab geht tiefer. Esc lässt los.</translation>
    </message>
    <message>
        <source>Record (R) starts and stops a recording. Mark (M) marks the touched place, or the place pressed last, as a finding with force and depth, listed here; F2 renames the finding. File › Report… writes a recording with findings, distances and margins as PDF.</source>
        <translation>Aufnehmen (R) startet und beendet eine Aufzeichnung. Markieren (M) markiert die berührte oder die zuletzt gedrückte Stelle als Befund mit Kraft und Tiefe, der hier steht; F2 benennt ihn um. Datei › Bericht… schreibt eine Aufzeichnung mit Befunden, Abständen und Sicherheitsabständen als PDF.</translation>
    </message>
</context>
<context>
    <name>palpate::app::SoundChoice</name>
    <message>
        <source>Touch sound</source>
        <translation>Tastton</translation>
    </message>
    <message>
        <source>Play a tone: higher pitch for stiffer tissue, louder for more force</source>
        <translation>Ton abspielen: höher bei steiferem Gewebe, lauter bei mehr Kraft</translation>
    </message>
    <message>
        <source>Touch sound stopped: the loudspeaker was disconnected.</source>
        <translation>Tastton beendet: Der Lautsprecher wurde getrennt.</translation>
    </message>
    <message>
        <source>Touch sound (%1)</source>
        <translation>Tastton (%1)</translation>
    </message>
</context>
<context>
    <name>palpate::app::StatusProgress</name>
    <message>
        <source>Progress</source>
        <translation>Fortschritt</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Cancel; the open scene does not change</source>
        <translation>Abbrechen; die offene Szene bleibt unverändert</translation>
    </message>
</context>
<context>
    <name>palpate::app::StructuresPart</name>
    <message>
        <source>Find a structure…</source>
        <translation>Struktur suchen…</translation>
    </message>
    <message>
        <source>List only structures with these words in their names</source>
        <translation>Nur Strukturen mit diesen Wörtern im Namen auflisten</translation>
    </message>
    <message>
        <source>Rename the structure…</source>
        <translation>Struktur umbenennen…</translation>
    </message>
    <message>
        <source>Rename the selected structure</source>
        <translation>Die gewählte Struktur umbenennen</translation>
    </message>
    <message>
        <source>Remove from the scene</source>
        <translation>Aus der Szene entfernen</translation>
    </message>
    <message>
        <source>Remove the selected structures from the scene; their files are kept</source>
        <translation>Die gewählten Strukturen aus der Szene entfernen; ihre Dateien bleiben erhalten</translation>
    </message>
    <message>
        <source>Ctrl+E  Ctrl+H</source>
        <translation>Strg+E  Strg+H</translation>
    </message>
    <message>
        <source>show or hide, turn touch on or off</source>
        <translation>zeigen oder verbergen, Tasten ein- oder ausschalten</translation>
    </message>
    <message>
        <source>letters</source>
        <translation>Buchstaben</translation>
    </message>
    <message>
        <source>go to the structure whose name starts with them</source>
        <translation>zur Struktur gehen, deren Name so beginnt</translation>
    </message>
    <message>
        <source>F2  Del</source>
        <translation>F2  Entf</translation>
    </message>
    <message>
        <source>rename, remove from the scene</source>
        <translation>umbenennen, aus der Szene entfernen</translation>
    </message>
    <message>
        <source>Ctrl+↓  ↑</source>
        <translation>Strg+↓  ↑</translation>
    </message>
    <message>
        <source>move one layer deeper or outwards</source>
        <translation>eine Schicht tiefer oder nach außen verschieben</translation>
    </message>
    <message>
        <source>Structures</source>
        <translation>Strukturen</translation>
    </message>
    <message>
        <source>Structures in colour-blind colours</source>
        <translation>Strukturen in Farben für Farbenblinde</translation>
    </message>
    <message>
        <source>Give lumps, arteries, portal vein, other veins, ducts and organs colours that colour-blind people can distinguish; also when meshes are opened</source>
        <translation>Knoten, Arterien, Pfortader, übrige Venen, Gänge und Organe in Farben zeigen, die Farbenblinde unterscheiden können; auch beim Öffnen von Netzen</translation>
    </message>
    <message>
        <source>Colour structures</source>
        <translation>Strukturen einfärben</translation>
    </message>
</context>
<context>
    <name>palpate::app::ThresholdDialog</name>
    <message>
        <source>The &amp;first was stiffer</source>
        <translation>Das &amp;erste war steifer</translation>
    </message>
    <message>
        <source>The &amp;second was stiffer</source>
        <translation>Das &amp;zweite war steifer</translation>
    </message>
    <message>
        <source>Delete the stored threshold</source>
        <translation>Gespeicherte Schwelle löschen</translation>
    </message>
    <message>
        <source>Also give verdicts on lumps for my hand</source>
        <translation>Urteile über Knoten auch für meine Hand angeben</translation>
    </message>
    <message>
        <source>My threshold</source>
        <translation>Meine Schwelle</translation>
    </message>
    <message>
        <source>%v of %m trials</source>
        <translation>%v von %m Durchgängen</translation>
    </message>
    <message>
        <source>Trials</source>
        <translation>Durchgänge</translation>
    </message>
    <message>
        <source>After “plainly felt”, “felt by a trained hand” and “too little for a trained hand”: whether the change of stiffness is above the stored threshold</source>
        <translation>Nach „deutlich tastbar“, „für eine geübte Hand tastbar“ und „zu wenig für eine geübte Hand“: ob die Änderung der Steifigkeit über der gespeicherten Schwelle liegt</translation>
    </message>
    <message>
        <source>Interrupted after %1 trials. An estimate needs at least %2; nothing was changed.</source>
        <translation>Nach %1 Durchgängen abgebrochen. Eine Schätzung braucht mindestens %2; nichts wurde geändert.</translation>
    </message>
    <message>
        <source>Done. Your threshold is below.</source>
        <translation>Fertig. Ihre Schwelle steht unten.</translation>
    </message>
    <message>
        <source>Interrupt</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Start</source>
        <translation>Beginnen</translation>
    </message>
    <message>
        <source>Which of two presses is stiffer? In each of 60 trials you press an invisible wall twice and tell which press was stiffer. The difference becomes smaller until you can only guess. It takes about 8 minutes.</source>
        <translation>Welches von zwei Malen ist steifer? In jedem von 60 Durchgängen drücken Sie zweimal auf eine unsichtbare Wand und geben an, welches Mal steifer war. Der Unterschied wird kleiner, bis Sie nur noch raten können. Das dauert etwa 8 Minuten.</translation>
    </message>
    <message>
        <source>This needs a device that renders force, with an open scene: with the mouse nothing is felt. Choose one in the menu Device.</source>
        <translation>Dies braucht ein Gerät, das Kraft ausgibt, und eine offene Szene: Mit der Maus ist nichts zu spüren. Wählen Sie eines im Menü Gerät.</translation>
    </message>
    <message>
        <source>First press: push away from you onto the wall, then move back.</source>
        <translation>Erstes Mal: Drücken Sie von sich weg auf die Wand, dann zurück.</translation>
    </message>
    <message>
        <source>Second press: push onto the wall again, then move back.</source>
        <translation>Zweites Mal: Drücken Sie wieder auf die Wand, dann zurück.</translation>
    </message>
    <message>
        <source>Which press was stiffer? Guess if you are not sure.</source>
        <translation>Welches Mal war steifer? Raten Sie, wenn Sie nicht sicher sind.</translation>
    </message>
    <message>
        <source>Your threshold: Weber fraction %1 (95 % interval %2 to %3 %), from %4 trials with %5. This increase of stiffness is told apart in 71 % of the trials.</source>
        <translation>Ihre Schwelle: Weber-Bruch %1 (95-%-Intervall %2 bis %3 %), aus %4 Durchgängen mit %5. Diese Zunahme der Steifigkeit wird in 71 % der Durchgänge erkannt.</translation>
    </message>
    <message>
        <source>No threshold of your own is stored.</source>
        <translation>Keine eigene Schwelle ist gespeichert.</translation>
    </message>
</context>
<context>
    <name>palpate::app::TissueOffer</name>
    <message>
        <source>The tissue of %1 was chosen by its name.</source>
        <translation>Das Gewebe von %1 wurde nach dem Namen gewählt.</translation>
    </message>
    <message>
        <source>The tissue of %1 structures was chosen by their names.</source>
        <translation>Das Gewebe von %1 Strukturen wurde nach den Namen gewählt.</translation>
    </message>
    <message numerus="yes">
        <source>No preset matches the name of %n: “Firm organ”, 0.5 N/mm.</source>
        <translation>
            <numerusform>Bei %n passt keine Vorgabe zum Namen: „Festes Organ“, 0,5 N/mm.</numerusform>
            <numerusform>Bei %n passt keine Vorgabe zum Namen: „Festes Organ“, 0,5 N/mm.</numerusform>
        </translation>
    </message>
    <message>
        <source>Tissue by name</source>
        <translation>Gewebe nach Namen</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>Rückgängig</translation>
    </message>
    <message>
        <source>Restore tissue</source>
        <translation>Gewebe wiederherstellen</translation>
    </message>
    <message>
        <source>Choose the tissue of unknown names</source>
        <translation>Gewebe unbekannter Namen wählen</translation>
    </message>
    <message>
        <source>Choose for all…</source>
        <translation>Für alle wählen…</translation>
    </message>
    <message>
        <source>Vessels, nerves and ducts that are not felt: %1.</source>
        <translation>Gefäße, Nerven und Gänge, die nicht gefühlt werden: %1.</translation>
    </message>
    <message>
        <source>Opacities chosen by name: %1.</source>
        <translation>Nach dem Namen gewählte Deckkraft: %1.</translation>
    </message>
</context>
<context>
    <name>palpate::app::TouchMapPart</name>
    <message>
        <source>Map of touch</source>
        <translation>Karte der Berührung</translation>
    </message>
    <message>
        <source>Next map of touch</source>
        <translation>Nächste Karte der Berührung</translation>
    </message>
    <message>
        <source>Previous map of touch</source>
        <translation>Vorige Karte der Berührung</translation>
    </message>
    <message>
        <source>Map of touch: %1</source>
        <translation>Karte der Berührung: %1</translation>
    </message>
    <message>
        <source>Colour the examined surface, in the recording up to the moment shown, or live</source>
        <translation>Färbt die untersuchte Oberfläche: in der Aufnahme bis zum gezeigten Zeitpunkt oder live</translation>
    </message>
</context>
<context>
    <name>palpate::app::TouchPart</name>
    <message>
        <source>Use of the pointer or the device</source>
        <translation>Verwendung von Zeiger oder Gerät</translation>
    </message>
    <message>
        <source>The pointer turns the view, or presses this far along the line of sight [mm] or with this force [N]. The wheel sets the value; P switches between the two</source>
        <translation>Der Zeiger dreht die Ansicht oder drückt so weit entlang der Blickrichtung [mm] oder mit dieser Kraft [N]. Das Rad stellt den Wert ein; P wechselt zwischen beidem</translation>
    </message>
    <message>
        <source>Palpate</source>
        <translation>Tasten</translation>
    </message>
    <message>
        <source>Palpate with the pointer: drag to press, wheel for depth or effort; off: the pointer moves the camera</source>
        <translation>Mit dem Zeiger tasten: ziehen zum Drücken, Rad für Tiefe oder Kraft; aus: der Zeiger bewegt die Ansicht</translation>
    </message>
    <message>
        <source>hold Space</source>
        <translation>Leertaste halten</translation>
    </message>
    <message>
        <source>palpate while the key is held</source>
        <translation>tasten, solange die Taste gehalten wird</translation>
    </message>
    <message>
        <source>drag</source>
        <translation>ziehen</translation>
    </message>
    <message>
        <source>camera: rotate · palpate: press and slide</source>
        <translation>Kamera: drehen · Tasten: drücken und gleiten</translation>
    </message>
    <message>
        <source>click</source>
        <translation>Klick</translation>
    </message>
    <message>
        <source>camera: select the structure (with Ctrl: add to the selection)</source>
        <translation>Kamera: die Struktur wählen (mit Strg: zur Auswahl hinzufügen)</translation>
    </message>
    <message>
        <source>right drag</source>
        <translation>rechts ziehen</translation>
    </message>
    <message>
        <source>camera: zoom · palpate: rotate</source>
        <translation>Kamera: zoomen · Tasten: drehen</translation>
    </message>
    <message>
        <source>middle drag</source>
        <translation>Mitte ziehen</translation>
    </message>
    <message>
        <source>pan</source>
        <translation>verschieben</translation>
    </message>
    <message>
        <source>wheel</source>
        <translation>Rad</translation>
    </message>
    <message>
        <source>camera: zoom · palpate: depth in mm, or effort in N (with Ctrl: zoom)</source>
        <translation>Kamera: zoomen · Tasten: Tiefe in mm oder Kraft in N (mit Strg: zoomen)</translation>
    </message>
    <message>
        <source>double-click</source>
        <translation>Doppelklick</translation>
    </message>
    <message>
        <source>centre the view on the point</source>
        <translation>die Ansicht auf den Punkt zentrieren</translation>
    </message>
    <message>
        <source>Let go</source>
        <translation>Loslassen</translation>
    </message>
    <message>
        <source>lift the hand, then return to the camera</source>
        <translation>Hand anheben, dann zurück zur Kamera</translation>
    </message>
    <message>
        <source>Touch</source>
        <translation>Berührung</translation>
    </message>
    <message>
        <source>Touching with the %1</source>
        <translation>Tasten mit: %1</translation>
    </message>
    <message>
        <source>Turning the view</source>
        <translation>Die Ansicht drehen</translation>
    </message>
</context>
<context>
    <name>palpate::app::ViewPart</name>
    <message>
        <source>Dent under the finger</source>
        <translation>Delle unter dem Finger</translation>
    </message>
    <message>
        <source>Draw soft tissue deformed at the contact, with a fine grid</source>
        <translation>Weiches Gewebe am Kontakt verformt zeichnen, mit feinem Gitter</translation>
    </message>
    <message>
        <source>From the front (A)</source>
        <translation>Von vorn (A)</translation>
    </message>
    <message>
        <source>From the back (P)</source>
        <translation>Von hinten (P)</translation>
    </message>
    <message>
        <source>From the left (L)</source>
        <translation>Von links (L)</translation>
    </message>
    <message>
        <source>From the right (R)</source>
        <translation>Von rechts (R)</translation>
    </message>
    <message>
        <source>From the head (S)</source>
        <translation>Vom Kopf (S)</translation>
    </message>
    <message>
        <source>From the feet (I)</source>
        <translation>Von den Füßen (I)</translation>
    </message>
    <message>
        <source>Oblique</source>
        <translation>Schräg</translation>
    </message>
</context>
<context>
    <name>palpate::ui::ActionList</name>
    <message>
        <source>%1 (%2)</source>
        <translation>%1 (%2)</translation>
    </message>
</context>
<context>
    <name>palpate::ui::ChipRow</name>
    <message>
        <source>More status</source>
        <translation>Weitere Angaben</translation>
    </message>
    <message>
        <source>Status items that do not fit in this row</source>
        <translation>Angaben, die nicht in diese Zeile passen</translation>
    </message>
</context>
<context>
    <name>palpate::ui::ConnectedDevices</name>
    <message>
        <source>3D Systems Touch, Phantom</source>
        <translation>3D Systems Touch, Phantom</translation>
    </message>
    <message>
        <source>Force Dimension omega, delta, sigma, lambda</source>
        <translation>Force Dimension omega, delta, sigma, lambda</translation>
    </message>
    <message>
        <source>Haply Inverse3, Minverse</source>
        <translation>Haply Inverse3, Minverse</translation>
    </message>
    <message>
        <source>WoodenHaptics, Polhem</source>
        <translation>WoodenHaptics, Polhem</translation>
    </message>
    <message>
        <source>SpaceMouse (input only)</source>
        <translation>SpaceMouse (nur Eingabe)</translation>
    </message>
    <message>
        <source>Tracked hand by OpenIGTLink (input only)</source>
        <translation>Verfolgte Hand über OpenIGTLink (nur Eingabe)</translation>
    </message>
    <message>
        <source>driver not usable</source>
        <translation>Treiber nicht verwendbar</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>connected: %1</source>
        <translation>angeschlossen: %1</translation>
    </message>
    <message>
        <source>Choose Device › %1.</source>
        <translation>Wählen Sie Gerät › %1.</translation>
    </message>
    <message>
        <source>not ready</source>
        <translation>nicht bereit</translation>
    </message>
    <message>
        <source>connected, not ready: %1</source>
        <translation>angeschlossen, nicht bereit: %1</translation>
    </message>
    <message>
        <source>It needs %1.</source>
        <translation>Es braucht %1.</translation>
    </message>
    <message>
        <source>supported; the maker&apos;s library is missing</source>
        <translation>unterstützt; die Bibliothek des Herstellers fehlt</translation>
    </message>
    <message>
        <source>driver cannot start</source>
        <translation>Treiber kann nicht starten</translation>
    </message>
    <message>
        <source>supported; none is connected</source>
        <translation>unterstützt; keines ist angeschlossen</translation>
    </message>
    <message>
        <source>driver not installed</source>
        <translation>Treiber nicht installiert</translation>
    </message>
    <message>
        <source>Install the plugin “%1”, a part of Palpate.</source>
        <translation>Installieren Sie das Plug-in „%1“, einen Teil von Palpate.</translation>
    </message>
    <message>
        <source>driver skipped</source>
        <translation>Treiber übersprungen</translation>
    </message>
    <message>
        <source>Install the maker&apos;s Touch driver and OpenHaptics 3, connect the arm, run Touch_Setup.</source>
        <translation>Installieren Sie den Touch-Treiber und OpenHaptics 3 des Herstellers, schließen Sie den Arm an, starten Sie Touch_Setup.</translation>
    </message>
    <message>
        <source>Install the maker&apos;s Force Dimension SDK 3, connect the arm, switch it on.</source>
        <translation>Installieren Sie das Force Dimension SDK 3 des Herstellers, schließen Sie den Arm an, schalten Sie ihn ein.</translation>
    </message>
    <message>
        <source>Start the maker&apos;s Inverse Service (3.1 or later), connect the arm, calibrate it in the Haply Hub.</source>
        <translation>Starten Sie den Inverse Service des Herstellers (ab 3.1), schließen Sie den Arm an, kalibrieren Sie ihn im Haply Hub.</translation>
    </message>
    <message>
        <source>Connect the arm by USB, choose it in the menu Device, then Device › Calibrate.</source>
        <translation>Schließen Sie den Arm über USB an, wählen Sie ihn im Menü Gerät, dann Gerät › Kalibrieren.</translation>
    </message>
    <message>
        <source>Connect it by USB. It has no motors: it moves the hand or the view, or sets the force.</source>
        <translation>Schließen Sie sie über USB an. Sie hat keine Motoren: Sie bewegt die Hand oder die Ansicht oder stellt die Kraft ein.</translation>
    </message>
    <message>
        <source>Start the program that sends the tracked tool, such as 3D Slicer, at port 18944. There is no force on the hand.</source>
        <translation>Starten Sie das Programm, das das verfolgte Werkzeug sendet, etwa 3D Slicer, an Port 18944. Auf die Hand wirkt keine Kraft.</translation>
    </message>
    <message>
        <source>connected, not supported yet</source>
        <translation>angeschlossen, noch nicht unterstützt</translation>
    </message>
    <message>
        <source>Devices</source>
        <translation>Geräte</translation>
    </message>
    <message>
        <source>Device</source>
        <translation>Gerät</translation>
    </message>
    <message>
        <source>State</source>
        <translation>Zustand</translation>
    </message>
    <message>
        <source>Next step</source>
        <translation>Nächster Schritt</translation>
    </message>
    <message>
        <source>The drivers were tested against emulated hardware only. The mouse and the simulated hand need no device. The page “devices” of the documentation (Help menu) describes each installation.</source>
        <translation>Die Treiber wurden nur gegen emulierte Hardware getestet. Maus und simulierte Hand brauchen kein Gerät. Die Seite „devices“ der Dokumentation (Menü Hilfe) beschreibt jede Installation.</translation>
    </message>
    <message>
        <source>Search again</source>
        <translation>Erneut suchen</translation>
    </message>
</context>
<context>
    <name>palpate::ui::DeviceChoice</name>
    <message>
        <source>Mouse</source>
        <translation>Maus</translation>
    </message>
    <message>
        <source>%1 (skipped)</source>
        <translation>%1 (übersprungen)</translation>
    </message>
    <message>
        <source>SpaceMouse moves the view</source>
        <translation>SpaceMouse bewegt die Ansicht</translation>
    </message>
    <message>
        <source>Calibrate</source>
        <translation>Kalibrieren</translation>
    </message>
    <message>
        <source>%1 lost</source>
        <translation>%1 verloren</translation>
    </message>
    <message>
        <source>%1: calibrate</source>
        <translation>%1: kalibrieren</translation>
    </message>
    <message>
        <source>Up to %1 N and %2 N/mm</source>
        <translation>Bis %1 N und %2 N/mm</translation>
    </message>
    <message>
        <source>mouse</source>
        <translation>Maus</translation>
    </message>
    <message>
        <source>simulated hand</source>
        <translation>simulierte Hand</translation>
    </message>
    <message>
        <source>SpaceMouse presses</source>
        <translation>SpaceMouse drückt</translation>
    </message>
    <message>
        <source>Mouse pointer over the view; the force is displayed, not felt</source>
        <translation>Mauszeiger über der Ansicht; die Kraft wird angezeigt, nicht gefühlt</translation>
    </message>
    <message>
        <source>Replay with current tissue</source>
        <translation>Wiedergabe mit aktuellem Gewebe</translation>
    </message>
    <message>
        <source>Repeats the motion of the open recording on the current tissue</source>
        <translation>Wiederholt die Bewegung der offenen Aufzeichnung am aktuellen Gewebe</translation>
    </message>
    <message>
        <source>Use the current pose of the device as calibration pose</source>
        <translation>Die jetzige Stellung des Geräts als Kalibrierstellung verwenden</translation>
    </message>
    <message>
        <source>Connected devices…</source>
        <translation>Angeschlossene Geräte…</translation>
    </message>
    <message>
        <source>The puck rotates and moves the anatomy while another device palpates</source>
        <translation>Der Puck dreht und verschiebt die Anatomie, während ein anderes Gerät palpiert</translation>
    </message>
    <message>
        <source>The pointer sets the place, the puck sets the force: the further down, the more newtons</source>
        <translation>Der Zeiger bestimmt die Stelle, der Puck die Kraft: je weiter nach unten, desto mehr Newton</translation>
    </message>
    <message>
        <source>replayed recording</source>
        <translation>wiedergegebene Aufzeichnung</translation>
    </message>
    <message>
        <source>Input device: %1</source>
        <translation>Eingabegerät: %1</translation>
    </message>
    <message>
        <source>No force feedback: forces up to %1 N are displayed only.</source>
        <translation>Keine Kraftrückkopplung: Kräfte bis %1 N werden nur angezeigt.</translation>
    </message>
    <message>
        <source>Simulated hand (no device)</source>
        <translation>Simulierte Hand (ohne Gerät)</translation>
    </message>
    <message>
        <source>Computed hand that palpates the centre of the view and responds to the force</source>
        <translation>Berechnete Hand, die die Mitte der Ansicht palpiert und auf die Kraft reagiert</translation>
    </message>
</context>
<context>
    <name>palpate::ui::DistancesPanel</name>
    <message>
        <source>0, they cross</source>
        <translation>0, sie schneiden sich</translation>
    </message>
    <message>
        <source>inside, %1 below</source>
        <translation>innen, %1 tief</translation>
    </message>
    <message>
        <source>around, %1</source>
        <translation>außen herum, %1</translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation>%1 %</translation>
    </message>
    <message>
        <source>Measure from</source>
        <translation>Messen von</translation>
    </message>
    <message>
        <source>Borders of the bands in millimetres</source>
        <translation>Grenzen der Bänder in Millimetern</translation>
    </message>
    <message>
        <source>Borders of the bands of the margin [mm], at most four, such as 5; 10</source>
        <translation>Grenzen der Bänder des Rands [mm], höchstens vier, zum Beispiel 5; 10</translation>
    </message>
    <message>
        <source>From</source>
        <translation>Von</translation>
    </message>
    <message>
        <source>Bands [mm]</source>
        <translation>Bänder [mm]</translation>
    </message>
    <message>
        <source>Distances between structures</source>
        <translation>Abstände zwischen Strukturen</translation>
    </message>
    <message>
        <source>Tapes</source>
        <translation>Maßbänder</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>Löschen</translation>
    </message>
    <message>
        <source>Delete the selected tapes (Del)</source>
        <translation>Die gewählten Maßbänder löschen (Entf)</translation>
    </message>
    <message>
        <source>T: tape between two places</source>
        <translation>T: Maßband zwischen zwei Orten</translation>
    </message>
    <message>
        <source>Bands: found “%1”, expected at most four ascending distances in mm, such as 5; 10.</source>
        <translation>Bänder: „%1“ gefunden, erwartet höchstens vier aufsteigende Abstände in mm, zum Beispiel 5; 10.</translation>
    </message>
    <message>
        <source>lumps</source>
        <translation>Knoten</translation>
    </message>
    <message>
        <source>Measuring…</source>
        <translation>Messe…</translation>
    </message>
    <message>
        <source>No lump here: choose the structure to measure from.</source>
        <translation>Kein Knoten vorhanden: wählen Sie die Struktur, von der gemessen wird.</translation>
    </message>
    <message>
        <source>To</source>
        <translation>Bis</translation>
    </message>
    <message>
        <source>Distance</source>
        <translation>Abstand</translation>
    </message>
    <message>
        <source>%1 of its area</source>
        <translation>%1 der Fläche</translation>
    </message>
    <message>
        <source>Select a row to see its closest points.</source>
        <translation>Wählen Sie eine Zeile, um ihre nächsten Punkte zu sehen.</translation>
    </message>
</context>
<context>
    <name>palpate::ui::EnergyBar</name>
    <message>
        <source>Energy observer</source>
        <translation>Energiebeobachter</translation>
    </message>
    <message>
        <source>%1 mJ</source>
        <translation>%1 mJ</translation>
    </message>
</context>
<context>
    <name>palpate::ui::EngineeringPanel</name>
    <message>
        <source>%1 µs</source>
        <translation>%1 µs</translation>
    </message>
    <message>
        <source>%1 ms</source>
        <translation>%1 ms</translation>
    </message>
    <message>
        <source>Click for the details (View › Engineering).</source>
        <translation>Für Einzelheiten klicken (Ansicht › Technik).</translation>
    </message>
    <message>
        <source>computer too busy</source>
        <translation>Rechner überlastet</translation>
    </message>
    <message>
        <source>force may stutter</source>
        <translation>Kraft kann stocken</translation>
    </message>
    <message>
        <source>running well</source>
        <translation>läuft gut</translation>
    </message>
    <message>
        <source>Constraints</source>
        <translation>Zwangsbedingungen</translation>
    </message>
    <message>
        <source>Solver</source>
        <translation>Löser</translation>
    </message>
    <message>
        <source>Measured rate</source>
        <translation>Gemessener Takt</translation>
    </message>
    <message>
        <source>Jitter</source>
        <translation>Jitter</translation>
    </message>
    <message>
        <source>Late ticks</source>
        <translation>Verspätete Takte</translation>
    </message>
    <message>
        <source>Dropped ticks</source>
        <translation>Verlorene Takte</translation>
    </message>
    <message>
        <source>Energy</source>
        <translation>Energie</translation>
    </message>
    <message>
        <source>Damping added</source>
        <translation>Dämpfung zusätzlich</translation>
    </message>
    <message>
        <source>Device round trip</source>
        <translation>Umlaufzeit des Geräts</translation>
    </message>
    <message>
        <source>Delay</source>
        <translation>Verzögerung</translation>
    </message>
    <message>
        <source>Device reports</source>
        <translation>Gerätemeldungen</translation>
    </message>
    <message>
        <source>%1 kHz</source>
        <translation>%1 kHz</translation>
    </message>
    <message>
        <source>Rate of the servo loop</source>
        <translation>Takt der Servoschleife</translation>
    </message>
    <message>
        <source>Servo rate</source>
        <translation>Servotakt</translation>
    </message>
    <message>
        <source>Any</source>
        <translation>Beliebig</translation>
    </message>
    <message>
        <source>CPU of the servo loop</source>
        <translation>CPU der Servoschleife</translation>
    </message>
    <message>
        <source>Servo CPU</source>
        <translation>Servo-CPU</translation>
    </message>
    <message>
        <source>99.9 % below %1</source>
        <translation>99,9 % unter %1</translation>
    </message>
    <message>
        <source>%1 mJ</source>
        <translation>%1 mJ</translation>
    </message>
    <message>
        <source>%1 N</source>
        <translation>%1 N</translation>
    </message>
    <message>
        <source>median %1, 99 % below %2</source>
        <translation>Median %1, 99 % unter %2</translation>
    </message>
    <message>
        <source>%1, %2 rejected, %3 dropouts</source>
        <translation>%1, %2 verworfen, %3 Ausfälle</translation>
    </message>
    <message>
        <source>Touch runs at %1 updates per second instead of %2, so forces may stutter. Close other programs.</source>
        <translation>Das Tasten wird %1-mal statt %2-mal je Sekunde berechnet; Kräfte können stocken. Schließen Sie andere Programme.</translation>
    </message>
    <message>
        <source>Touch has no real-time priority, so other programs may make the force stutter. The list of messages (F4) explains how to allow real-time priority.</source>
        <translation>Das Tasten hat keine Echtzeitpriorität; andere Programme können die Kraft stocken lassen. Die Liste der Meldungen (F4) erklärt, wie sie erlaubt wird.</translation>
    </message>
    <message>
        <source>Touch runs at the full rate of %1 updates per second.</source>
        <translation>Das Tasten läuft mit vollen %1 Berechnungen je Sekunde.</translation>
    </message>
    <message>
        <source>Energy observer: energy that the hand has put into the touched tissue and not recovered [mJ].
A negative value means that the simulation adds energy; damping then removes the surplus.</source>
        <translation>Energiebeobachter: Energie, die die Hand in das berührte Gewebe gesteckt und nicht zurückbekommen hat [mJ].
Ein negativer Wert heißt, dass die Simulation Energie zuführt; Dämpfung entfernt dann den Überschuss.</translation>
    </message>
    <message>
        <source>Real-time settings of the servo thread</source>
        <translation>Echtzeiteinstellungen des Servo-Threads</translation>
    </message>
    <message>
        <source>Active constraints: surface planes that hold the hand back (at most 3)</source>
        <translation>Aktive Zwangsbedingungen: Ebenen der Oberfläche, die die Hand zurückhalten (höchstens 3)</translation>
    </message>
    <message>
        <source>Solver time per tick, for ticks with a hand</source>
        <translation>Rechenzeit je Takt, aus Takten mit Hand</translation>
    </message>
    <message>
        <source>Servo ticks per second, over the last half second [kHz]</source>
        <translation>Servotakte je Sekunde, über die letzte halbe Sekunde [kHz]</translation>
    </message>
    <message>
        <source>Deviation of the tick interval from the period; 99.9 % of the ticks stay below this value</source>
        <translation>Abweichung des Taktabstands von der Periode; 99,9 % der Takte bleiben unter diesem Wert</translation>
    </message>
    <message>
        <source>Ticks that finished late, out of all ticks since the loop started, and the periods skipped as a result</source>
        <translation>Takte, die zu spät endeten, von allen seit Beginn der Schleife, und die deshalb ausgelassenen Perioden</translation>
    </message>
    <message>
        <source>Ticks missing from this recording because the disk was too slow</source>
        <translation>Takte, die in dieser Aufzeichnung fehlen, weil der Datenträger zu langsam war</translation>
    </message>
    <message>
        <source>Energy observer: energy that the hand has put into the touched tissue and not recovered [mJ]</source>
        <translation>Energiebeobachter: Energie, die die Hand in das berührte Gewebe gesteckt und nicht zurückbekommen hat [mJ]</translation>
    </message>
    <message>
        <source>Force that the passivity controller adds against the motion [N]</source>
        <translation>Kraft, die der Passivitätsregler gegen die Bewegung hinzufügt [N]</translation>
    </message>
    <message>
        <source>Time from receiving a device report to writing the resulting force</source>
        <translation>Zeit vom Empfang einer Gerätemeldung bis zum Schreiben der zugehörigen Kraft</translation>
    </message>
    <message>
        <source>Assumed delay until the force acts; limits the stable stiffness</source>
        <translation>Angenommene Verzögerung, bis die Kraft wirkt; begrenzt die stabile Steifigkeit</translation>
    </message>
    <message>
        <source>Reports received, reports rejected as implausible, and connection losses</source>
        <translation>Empfangene Meldungen, als unglaubwürdig verworfene und Verbindungsverluste</translation>
    </message>
    <message>
        <source>Ticks per second. A faster loop keeps stiffer tissue stable if the device keeps up; check the jitter.</source>
        <translation>Takte je Sekunde. Eine schnellere Schleife hält steiferes Gewebe stabil, wenn das Gerät mitkommt; auf den Jitter achten.</translation>
    </message>
    <message>
        <source>CPU %1 only</source>
        <translation>Nur CPU %1</translation>
    </message>
    <message>
        <source>CPU for the servo loop. A single CPU helps only if no other program uses that CPU;
otherwise choose &quot;Any&quot;.</source>
        <translation>CPU für die Servoschleife. Eine einzelne CPU hilft nur, wenn kein anderes Programm sie nutzt;
sonst „Beliebig“ wählen.</translation>
    </message>
    <message>
        <source>%1 of %2, %3 skipped</source>
        <translation>%1 von %2, %3 ausgelassen</translation>
    </message>
</context>
<context>
    <name>palpate::ui::ExerciseBar</name>
    <message>
        <source>Time of the exercise</source>
        <translation>Zeit der Übung</translation>
    </message>
    <message>
        <source>Force and force ceiling of the exercise</source>
        <translation>Kraft und Kraftgrenze der Übung</translation>
    </message>
</context>
<context>
    <name>palpate::ui::FeltOverlay</name>
    <message>
        <source>pressed %1 mm</source>
        <translation>%1 mm eingedrückt</translation>
    </message>
    <message>
        <source>touched lightly</source>
        <translation>leicht berührt</translation>
    </message>
    <message>
        <source>not judged</source>
        <translation>nicht beurteilt</translation>
    </message>
    <message>
        <source>0 %: no lump</source>
        <translation>0 %: kein Knoten</translation>
    </message>
    <message>
        <source>28 %: plainly felt</source>
        <translation>28 %: deutlich tastbar</translation>
    </message>
    <message>
        <source>Palpability, %1
(estimate)</source>
        <translation>Tastbarkeit, %1
(Schätzung)</translation>
    </message>
    <message>
        <source>7 %: not noticed</source>
        <translation>7 %: nicht bemerkt</translation>
    </message>
    <message>
        <source>14 %: by a trained hand</source>
        <translation>14 %: mit geübter Hand</translation>
    </message>
    <message>
        <source>%1 %: maximum here</source>
        <translation>%1 %: Maximum hier</translation>
    </message>
    <message>
        <source>Palpability</source>
        <translation>Tastbarkeit</translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation>%1 %</translation>
    </message>
</context>
<context>
    <name>palpate::ui::FeltPanel</name>
    <message>
        <source>Estimate for research and rehearsal.</source>
        <translation>Schätzung für Forschung und Übung.</translation>
    </message>
    <message>
        <source>Lump</source>
        <translation>Knoten</translation>
    </message>
    <message>
        <source>Pressed %1 mm</source>
        <translation>%1 mm eingedrückt</translation>
    </message>
    <message>
        <source>Touched lightly</source>
        <translation>Leicht berührt</translation>
    </message>
    <message>
        <source>As typed</source>
        <translation>Wie eingegeben</translation>
    </message>
    <message>
        <source>From the two Young&apos;s moduli</source>
        <translation>Aus den beiden Elastizitätsmoduln</translation>
    </message>
    <message>
        <source>Young&apos;s modulus of the lump [kPa]</source>
        <translation>Elastizitätsmodul des Knotens [kPa]</translation>
    </message>
    <message>
        <source>Young&apos;s modulus of the organ [kPa]</source>
        <translation>Elastizitätsmodul des Organs [kPa]</translation>
    </message>
    <message>
        <source> kPa</source>
        <translation> kPa</translation>
    </message>
    <message>
        <source>%1 mm</source>
        <translation>%1 mm</translation>
    </message>
    <message>
        <source>in %1</source>
        <translation>in %1</translation>
    </message>
    <message>
        <source>between %1 and %2</source>
        <translation>zwischen %1 und %2</translation>
    </message>
    <message>
        <source>Stiffness of %1</source>
        <translation>Steifigkeit von %1</translation>
    </message>
    <message>
        <source>Stiffness ratio</source>
        <translation>Steifigkeitsverhältnis</translation>
    </message>
    <message>
        <source>Tissue above</source>
        <translation>Gewebe darüber</translation>
    </message>
    <message>
        <source>Lumps and their palpability</source>
        <translation>Knoten und ihre Tastbarkeit</translation>
    </message>
    <message>
        <source>Press depth of the finger</source>
        <translation>Eindrucktiefe des Fingers</translation>
    </message>
    <message>
        <source>Colours: pressed %1 mm</source>
        <translation>Farben: %1 mm eingedrückt</translation>
    </message>
    <message>
        <source>Colours: touched lightly</source>
        <translation>Farben: leicht berührt</translation>
    </message>
    <message>
        <source>Show the best place</source>
        <translation>Die beste Stelle zeigen</translation>
    </message>
    <message>
        <source>Stiffness of the lump relative to the organ</source>
        <translation>Steifigkeit des Knotens im Verhältnis zum Organ</translation>
    </message>
    <message>
        <source>Source of the stiffness ratio</source>
        <translation>Quelle des Steifigkeitsverhältnisses</translation>
    </message>
    <message>
        <source>From tissues or names</source>
        <translation>Nach Gewebe oder Namen</translation>
    </message>
    <message>
        <source>Published: %1, %2</source>
        <translation>Veröffentlicht: %1, %2</translation>
    </message>
    <message>
        <source>to</source>
        <translation>zu</translation>
    </message>
    <message>
        <source>Computing…</source>
        <translation>Wird berechnet…</translation>
    </message>
    <message>
        <source>exposed</source>
        <translation>liegt frei</translation>
    </message>
    <message>
        <source>enter a ratio or choose a published one</source>
        <translation>eingeben oder einen veröffentlichten Wert wählen</translation>
    </message>
    <message>
        <source>Stiffness ratio to the organ:</source>
        <translation>Steifigkeitsverhältnis zum Organ:</translation>
    </message>
    <message>
        <source>%1, stiffness ratio to %2:</source>
        <translation>%1, Steifigkeitsverhältnis zu %2:</translation>
    </message>
    <message>
        <source>No place above this lump can be judged.</source>
        <translation>Keine Stelle über diesem Knoten lässt sich beurteilen.</translation>
    </message>
    <message>
        <source>Ratio</source>
        <translation>Verhältnis</translation>
    </message>
</context>
<context>
    <name>palpate::ui::FeltWords</name>
    <message>
        <source>not by hand</source>
        <translation>nicht mit der Hand</translation>
    </message>
    <message>
        <source>by a trained hand</source>
        <translation>mit geübter Hand</translation>
    </message>
    <message>
        <source>plainly</source>
        <translation>deutlich</translation>
    </message>
    <message>
        <source>not judged</source>
        <translation>nicht beurteilt</translation>
    </message>
    <message>
        <source>as typed</source>
        <translation>wie eingegeben</translation>
    </message>
    <message>
        <source>from the moduli</source>
        <translation>aus den Moduln</translation>
    </message>
    <message>
        <source>from the tissues&apos; stiffness</source>
        <translation>aus der Steifigkeit der Gewebe</translation>
    </message>
    <message>
        <source>plainly felt</source>
        <translation>deutlich tastbar</translation>
    </message>
    <message>
        <source>not judged here: %1</source>
        <translation>hier nicht beurteilt: %1</translation>
    </message>
    <message>
        <source>;
%1 when pressed %2 mm</source>
        <translation>;
%1 bei %2 mm eingedrückt</translation>
    </message>
    <message>
        <source>%1: %2 mm below, %3 (%4 … %5 %): %6</source>
        <translation>%1: %2 mm darunter, %3 (%4 … %5 %): %6</translation>
    </message>
    <message>
        <source>stiffness ratio not known</source>
        <translation>Steifigkeitsverhältnis unbekannt</translation>
    </message>
    <message>
        <source>published for such lumps</source>
        <translation>für solche Knoten veröffentlicht</translation>
    </message>
    <message>
        <source>%1 (at %2: %3; at %4: %5)</source>
        <translation>%1 (bei %2: %3; bei %4: %5)</translation>
    </message>
    <message>
        <source>surface too curved</source>
        <translation>Oberfläche zu stark gekrümmt</translation>
    </message>
    <message>
        <source>organ too thin</source>
        <translation>Organ zu dünn</translation>
    </message>
    <message>
        <source>lumps overlap</source>
        <translation>Knoten überlappen</translation>
    </message>
    <message>
        <source>felt by a trained hand</source>
        <translation>mit geübter Hand tastbar</translation>
    </message>
    <message>
        <source>too little for a trained hand</source>
        <translation>zu wenig für eine geübte Hand</translation>
    </message>
    <message>
        <source>unknown</source>
        <translation>unbekannt</translation>
    </message>
    <message>
        <source>no palpable lump here</source>
        <translation>hier kein tastbarer Knoten</translation>
    </message>
    <message>
        <source>%1 (stiffness ratio %2)</source>
        <translation>%1 (Steifigkeitsverhältnis %2)</translation>
    </message>
    <message>
        <source>%1 (%2)</source>
        <translation>%1 (%2)</translation>
    </message>
</context>
<context>
    <name>palpate::ui::FindingsModel</name>
    <message>
        <source>%1: %2 N, %3 mm deep</source>
        <translation>%1: %2 N, %3 mm tief</translation>
    </message>
    <message>
        <source>Delete %1</source>
        <translation>%1 löschen</translation>
    </message>
    <message>
        <source>Delete %1 findings</source>
        <translation>%1 Befunde löschen</translation>
    </message>
    <message>
        <source>note</source>
        <translation>Notiz</translation>
    </message>
    <message>
        <source>№</source>
        <translation>Nr.</translation>
    </message>
    <message>
        <source>Type</source>
        <translation>Art</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Name</translation>
    </message>
    <message>
        <source>Where</source>
        <translation>Wo</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Größe</translation>
    </message>
    <message>
        <source>Note</source>
        <translation>Notiz</translation>
    </message>
    <message>
        <source>Type of %1</source>
        <translation>Art von %1</translation>
    </message>
    <message>
        <source>Rename %1</source>
        <translation>%1 umbenennen</translation>
    </message>
    <message>
        <source>Size of %1</source>
        <translation>Größe von %1</translation>
    </message>
    <message>
        <source>Note on %1</source>
        <translation>Notiz zu %1</translation>
    </message>
    <message>
        <source>%1 in %2</source>
        <translation>%1 in %2</translation>
    </message>
    <message>
        <source>stiffness %1 N/mm</source>
        <translation>Steifigkeit %1 N/mm</translation>
    </message>
    <message>
        <source>Number in the view</source>
        <translation>Nummer in der Ansicht</translation>
    </message>
    <message>
        <source>Palpated structure and surrounding organ</source>
        <translation>Palpierte Struktur und umgebendes Organ</translation>
    </message>
    <message>
        <source>Estimated diameter [mm]</source>
        <translation>Geschätzter Durchmesser [mm]</translation>
    </message>
    <message>
        <source>Force of this structure at the time of marking [N]</source>
        <translation>Kraft dieser Struktur beim Markieren [N]</translation>
    </message>
    <message>
        <source>Force [N]</source>
        <translation>Kraft [N]</translation>
    </message>
    <message>
        <source>Depth in this structure at the time of marking [mm]</source>
        <translation>Tiefe in dieser Struktur beim Markieren [mm]</translation>
    </message>
    <message>
        <source>Depth [mm]</source>
        <translation>Tiefe [mm]</translation>
    </message>
    <message>
        <source>Size: found “%1”, expected millimetres such as %2.</source>
        <translation>Größe: „%1“ gefunden, erwartet sind Millimeter wie %2.</translation>
    </message>
</context>
<context>
    <name>palpate::ui::FindingsPanel</name>
    <message>
        <source>Findings and notes</source>
        <translation>Befunde und Notizen</translation>
    </message>
    <message>
        <source>New note without a place</source>
        <translation>Neue Notiz ohne Stelle</translation>
    </message>
    <message>
        <source>Write a note (N), Enter saves</source>
        <translation>Notiz schreiben (N), Enter sichert</translation>
    </message>
    <message>
        <source>Go there</source>
        <translation>Dorthin</translation>
    </message>
    <message>
        <source>Play from here</source>
        <translation>Ab hier abspielen</translation>
    </message>
    <message>
        <source>Type</source>
        <translation>Art</translation>
    </message>
    <message>
        <source>Rename</source>
        <translation>Umbenennen</translation>
    </message>
    <message>
        <source>Enter the size</source>
        <translation>Größe eingeben</translation>
    </message>
    <message>
        <source>Write a note</source>
        <translation>Notiz schreiben</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>Löschen</translation>
    </message>
    <message>
        <source>No findings yet. Press on a place, then click Mark or press M.</source>
        <translation>Noch keine Befunde. Auf eine Stelle drücken, dann auf Markieren klicken oder M drücken.</translation>
    </message>
</context>
<context>
    <name>palpate::ui::FingerInset</name>
    <message>
        <source>Section along the finger</source>
        <translation>Schnitt entlang des Fingers</translation>
    </message>
    <message>
        <source>%1 mm</source>
        <translation>%1 mm</translation>
    </message>
    <message>
        <source>Along the finger: touch a structure</source>
        <translation>Entlang des Fingers: eine Struktur berühren</translation>
    </message>
    <message>
        <source>Along the finger</source>
        <translation>Entlang des Fingers</translation>
    </message>
</context>
<context>
    <name>palpate::ui::ForceBar</name>
    <message>
        <source>Force of the model [N]; the bar ends at the device&apos;s limit of %1 N</source>
        <translation>Kraft des Modells [N]; der Balken endet an der Grenze des Geräts von %1 N</translation>
    </message>
    <message>
        <source>limit %1 N</source>
        <translation>Grenze %1 N</translation>
    </message>
    <message>
        <source>%1 N of %2 N</source>
        <translation>%1 N von %2 N</translation>
    </message>
    <message>
        <source>Force in newtons</source>
        <translation>Kraft in Newton</translation>
    </message>
</context>
<context>
    <name>palpate::ui::ForceTimeline</name>
    <message>
        <source>The force of a recording appears here</source>
        <translation>Hier erscheint die Kraft einer Aufzeichnung</translation>
    </message>
    <message>
        <source> s</source>
        <translation> s</translation>
    </message>
    <message>
        <source>%1 N</source>
        <translation>%1 N</translation>
    </message>
    <message>
        <source>%1 s: %2</source>
        <translation>%1 s: %2</translation>
    </message>
    <message>
        <source>no recording</source>
        <translation>keine Aufzeichnung</translation>
    </message>
    <message>
        <source>%1 of %2 s</source>
        <translation>%1 von %2 s</translation>
    </message>
    <message>
        <source>%1, %2 N</source>
        <translation>%1, %2 N</translation>
    </message>
    <message>
        <source>Force timeline of the recording</source>
        <translation>Zeitachse der Kraft in der Aufzeichnung</translation>
    </message>
    <message>
        <source>Force [N] during the recording. Click or drag to seek; ← and → step by 0.1 s, Home and End jump to the ends.</source>
        <translation>Kraft [N] während der Aufzeichnung. Klicken oder ziehen, um dorthin zu springen; ← und → gehen um 0,1 s, Pos1 und Ende an die Enden.</translation>
    </message>
</context>
<context>
    <name>palpate::ui::HandControl</name>
    <message>
        <source>The whole scene</source>
        <translation>Die ganze Szene</translation>
    </message>
    <message>
        <source>%1; using any CPU</source>
        <translation>%1; jede CPU ist möglich</translation>
    </message>
    <message>
        <source>First touch a place, point at one or mark a finding (M).</source>
        <translation>Zuerst eine Stelle berühren, darauf zeigen oder einen Befund markieren (M).</translation>
    </message>
    <message>
        <source>No visible structure to fit the workspace to.</source>
        <translation>Keine sichtbare Struktur, an die der Arbeitsraum angepasst werden kann.</translation>
    </message>
    <message>
        <source>%1 fills the workspace. The hand stays in contact; Centre moves the hand to the middle.</source>
        <translation>%1 füllt den Arbeitsraum. Die Hand bleibt in Kontakt; „Mitte“ bringt sie in die Mitte.</translation>
    </message>
    <message>
        <source>%1 fills the workspace.</source>
        <translation>%1 füllt den Arbeitsraum.</translation>
    </message>
    <message>
        <source>10 mm around the contact</source>
        <translation>10 mm um den Kontakt</translation>
    </message>
    <message>
        <source>10 mm around the pointer</source>
        <translation>10 mm um den Zeiger</translation>
    </message>
    <message>
        <source>10 mm around finding %1</source>
        <translation>10 mm um Befund %1</translation>
    </message>
</context>
<context>
    <name>palpate::ui::HandPanel</name>
    <message>
        <source>1 mm of the device is %1 mm of the scene.</source>
        <translation>1 mm des Geräts ist %1 mm der Szene.</translation>
    </message>
    <message>
        <source>Nothing yet</source>
        <translation>Noch nichts</translation>
    </message>
    <message>
        <source>Force on the hand</source>
        <translation>Kraft auf die Hand</translation>
    </message>
    <message>
        <source> mm per mm</source>
        <translation> mm je mm</translation>
    </message>
    <message>
        <source>Scale</source>
        <translation>Maßstab</translation>
    </message>
    <message>
        <source>Nothing</source>
        <translation>Nichts</translation>
    </message>
    <message>
        <source>Centre</source>
        <translation>Mitte</translation>
    </message>
    <message>
        <source>Button %1</source>
        <translation>Taste %1</translation>
    </message>
    <message>
        <source>Left hand</source>
        <translation>Linke Hand</translation>
    </message>
    <message>
        <source>Force on the hand %1 N of %2 N</source>
        <translation>Kraft auf die Hand %1 N von %2 N</translation>
    </message>
    <message>
        <source>Everything</source>
        <translation>Alles</translation>
    </message>
    <message>
        <source>Organ</source>
        <translation>Organ</translation>
    </message>
    <message>
        <source>Lump</source>
        <translation>Knoten</translation>
    </message>
    <message>
        <source>Lift the hand</source>
        <translation>Hand anheben</translation>
    </message>
    <message>
        <source>Depth (wheel)</source>
        <translation>Tiefe (Rad)</translation>
    </message>
    <message>
        <source> N</source>
        <translation> N</translation>
    </message>
    <message>
        <source>No motors: forces are displayed, not felt. Any stiffness is possible.</source>
        <translation>Keine Motoren: Kräfte werden angezeigt, nicht gefühlt. Jede Steifigkeit ist möglich.</translation>
    </message>
    <message>
        <source>This device can render tissue up to %1 N/mm.</source>
        <translation>Dieses Gerät kann Gewebe bis %1 N/mm darstellen.</translation>
    </message>
    <message>
        <source>Edge of the workspace: move the device back to the middle. Until then, the hand in the scene does not move.</source>
        <translation>Rand des Arbeitsraums: Führen Sie das Gerät zur Mitte zurück. Bis dahin bewegt sich die Hand in der Szene nicht.</translation>
    </message>
    <message>
        <source>Lifted: the device moves, the hand in the scene does not.</source>
        <translation>Angehoben: Das Gerät bewegt sich, die Hand in der Szene nicht.</translation>
    </message>
    <message>
        <source>The hand is inside %1, which is only felt from outside. Move the hand out towards you first.</source>
        <translation>Die Hand ist in %1, nur von außen tastbar. Führen Sie die Hand erst zu sich heraus.</translation>
    </message>
    <message>
        <source>Unscaled: 1 mm of the device is 1 mm of the scene.</source>
        <translation>Ohne Maßstab: 1 mm des Geräts ist 1 mm der Szene.</translation>
    </message>
    <message>
        <source>%1 fills the workspace: 1 mm of the device is %2 mm of the scene.</source>
        <translation>%1 füllt den Arbeitsraum: 1 mm des Geräts ist %2 mm der Szene.</translation>
    </message>
    <message>
        <source>Maximum tissue stiffness</source>
        <translation>Maximale Gewebesteifigkeit</translation>
    </message>
    <message>
        <source>Map the full device range to all visible structures (W)</source>
        <translation>Den ganzen Weg des Geräts auf alle sichtbaren Strukturen abbilden (W)</translation>
    </message>
    <message>
        <source>Map the full device range to the touched organ, or else to the organ under the pointer or the selected one (O)</source>
        <translation>Den ganzen Weg des Geräts auf das berührte Organ abbilden, sonst auf das unter dem Zeiger oder das ausgewählte (O)</translation>
    </message>
    <message>
        <source>Map the full device range to 10 mm around the contact, or else around the pointer or the newest finding (L)</source>
        <translation>Den ganzen Weg des Geräts auf 10 mm um den Kontakt abbilden, sonst um den Zeiger oder den neuesten Befund (L)</translation>
    </message>
    <message>
        <source>Fit workspace to</source>
        <translation>Arbeitsraum anpassen an</translation>
    </message>
    <message>
        <source>Current workspace</source>
        <translation>Aktueller Arbeitsraum</translation>
    </message>
    <message>
        <source>Scene millimetres per device millimetre</source>
        <translation>Millimeter der Szene je Millimeter des Geräts</translation>
    </message>
    <message>
        <source>View</source>
        <translation>Ansicht</translation>
    </message>
    <message>
        <source>Patient</source>
        <translation>Patient</translation>
    </message>
    <message>
        <source>Scene axes</source>
        <translation>Szenenachsen</translation>
    </message>
    <message>
        <source>Device orientation</source>
        <translation>Ausrichtung des Geräts</translation>
    </message>
    <message>
        <source>View: right is right on screen, however the view is rotated.
Patient: right is the patient&apos;s left, up is towards the head.
Scene axes: device coordinates equal scene coordinates, without scaling; the hand cannot be lifted.</source>
        <translation>Ansicht: Rechts ist rechts auf dem Bildschirm, wie auch immer die Ansicht gedreht ist.
Patient: Rechts ist die linke Seite des Patienten, oben ist kopfwärts.
Szenenachsen: Die Koordinaten des Geräts sind die der Szene, ohne Maßstab; die Hand lässt sich nicht anheben.</translation>
    </message>
    <message>
        <source>Aligned with</source>
        <translation>Ausgerichtet an</translation>
    </message>
    <message>
        <source>Function of button %1</source>
        <translation>Funktion von Taste %1</translation>
    </message>
    <message>
        <source>Swaps the first two buttons</source>
        <translation>Vertauscht die ersten beiden Tasten</translation>
    </message>
    <message>
        <source>While held, the device moves and the hand in the scene does not; C switches lifting on and off</source>
        <translation>Solange gehalten, bewegt sich das Gerät und die Hand in der Szene nicht; C schaltet um</translation>
    </message>
    <message>
        <source>Centres the device range on the fitted region</source>
        <translation>Zentriert den Weg des Geräts auf den angepassten Bereich</translation>
    </message>
    <message>
        <source>Force (hold)</source>
        <translation>Kraft (halten)</translation>
    </message>
    <message>
        <source>Press mode</source>
        <translation>Art des Drückens</translation>
    </message>
    <message>
        <source>Depth: the same depth everywhere; a stiff place pushes back harder.
Force: the same force everywhere; a stiff place yields less. The force rises by 1 N per second while the button is held; with a pen, the pen pressure sets the force. (E)</source>
        <translation>Tiefe: überall gleich tief; eine steife Stelle drückt stärker zurück.
Kraft: überall gleich stark; eine steife Stelle gibt weniger nach. Die Kraft wächst um 1 N je Sekunde, solange die Taste gehalten wird; bei einem Stift bestimmt der Stiftdruck die Kraft. (E)</translation>
    </message>
    <message>
        <source>Maximum force</source>
        <translation>Größte Kraft</translation>
    </message>
    <message>
        <source>Force limit of a press and force at full pen pressure; the wheel changes the value by 0.5 N</source>
        <translation>Kraftgrenze eines Drucks und Kraft bei vollem Stiftdruck; das Rad ändert den Wert um 0,5 N</translation>
    </message>
    <message>
        <source>Maximum</source>
        <translation>Maximum</translation>
    </message>
    <message>
        <source>Computed hand, no device: it presses what is in the middle of the view. Force and stiffness have the limits of the chosen device.</source>
        <translation>Berechnete Hand, kein Gerät: Sie drückt auf das, was in der Mitte der Ansicht ist. Kraft und Steifigkeit haben die Grenzen des gewählten Geräts.</translation>
    </message>
    <message>
        <source>Limits of</source>
        <translation>Grenzen von</translation>
    </message>
    <message>
        <source>Shows how tissue feels at a device that is not here: force, stiffness and damping are bounded as by this device</source>
        <translation>Zeigt, wie sich Gewebe an einem Gerät anfühlt, das nicht hier ist: Kraft, Steifigkeit und Dämpfung sind begrenzt wie bei diesem Gerät</translation>
    </message>
    <message>
        <source>Simulated hand</source>
        <translation>Simulierte Hand</translation>
    </message>
</context>
<context>
    <name>palpate::ui::HintLine</name>
    <message>
        <source>Latest message; F4 shows all</source>
        <translation>Neueste Meldung; F4 zeigt alle</translation>
    </message>
    <message>
        <source>%1
Click here or press F4 for all messages</source>
        <translation>%1
Hier klicken oder F4 drücken für alle Meldungen</translation>
    </message>
    <message>
        <source>No new messages</source>
        <translation>Keine neuen Meldungen</translation>
    </message>
</context>
<context>
    <name>palpate::ui::KeysCard</name>
    <message>
        <source>All keys</source>
        <translation>Alle Tasten</translation>
    </message>
    <message>
        <source>in the list: %1</source>
        <translation>in der Liste: %1</translation>
    </message>
</context>
<context>
    <name>palpate::ui::LawEditor</name>
    <message>
        <source>Load points…</source>
        <translation>Punkte laden…</translation>
    </message>
    <message>
        <source>Linear</source>
        <translation>Linear</translation>
    </message>
    <message>
        <source>Stiffer with depth</source>
        <translation>Steifer mit der Tiefe</translation>
    </message>
    <message>
        <source>Ball on soft tissue</source>
        <translation>Kugel auf weichem Gewebe</translation>
    </message>
    <message>
        <source>Thin layer</source>
        <translation>Dünne Schicht</translation>
    </message>
    <message>
        <source>Click</source>
        <translation>Klick</translation>
    </message>
    <message>
        <source>Measured points</source>
        <translation>Gemessene Punkte</translation>
    </message>
    <message>
        <source>%1 in %2</source>
        <translation>%1 in %2</translation>
    </message>
    <message>
        <source>%1 [%2]</source>
        <translation>%1 [%2]</translation>
    </message>
    <message>
        <source>Tables (*.csv);;All files (*)</source>
        <translation>Tabellen (*.csv);;Alle Dateien (*)</translation>
    </message>
    <message>
        <source>Force law</source>
        <translation>Kraftgesetz</translation>
    </message>
    <message>
        <source>How the force rises with depth</source>
        <translation>Wie die Kraft mit der Tiefe steigt</translation>
    </message>
    <message>
        <source>Load a measured curve from a CSV file with columns depth_mm and force_N</source>
        <translation>Eine gemessene Kurve aus einer CSV-Datei mit den Spalten depth_mm und force_N laden</translation>
    </message>
</context>
<context>
    <name>palpate::ui::LawPlot</name>
    <message>
        <source>%1 mm deep</source>
        <translation>%1 mm tief</translation>
    </message>
    <message>
        <source>Force [N]</source>
        <translation>Kraft [N]</translation>
    </message>
    <message>
        <source>– – device %1 N/mm</source>
        <translation>– – Gerät %1 N/mm</translation>
    </message>
    <message>
        <source>now %1 mm</source>
        <translation>jetzt %1 mm</translation>
    </message>
    <message>
        <source>now %1 mm, here × %2</source>
        <translation>jetzt %1 mm, hier × %2</translation>
    </message>
    <message>
        <source>Force in newtons over depth in millimetres</source>
        <translation>Kraft in Newton über der Tiefe in Millimetern</translation>
    </message>
    <message>
        <source>Force [N] over depth [mm]. Drag a point, or select one with ← → and move with ↑ ↓</source>
        <translation>Kraft [N] über der Tiefe [mm]. Einen Punkt ziehen oder mit ← → wählen und mit ↑ ↓ bewegen</translation>
    </message>
    <message>
        <source>Force [N] over depth [mm]</source>
        <translation>Kraft [N] über der Tiefe [mm]</translation>
    </message>
</context>
<context>
    <name>palpate::ui::LegendGrip</name>
    <message>
        <source>Close the legend; the View menu shows it again</source>
        <translation>Legende schließen; das Menü Ansicht zeigt sie wieder</translation>
    </message>
    <message>
        <source>Drag the legend to another corner</source>
        <translation>Legende in eine andere Ecke ziehen</translation>
    </message>
</context>
<context>
    <name>palpate::ui::LiveTouch</name>
    <message>
        <source>%1 can render tissue up to %2 N/mm.</source>
        <translation>%1 kann Gewebe bis %2 N/mm darstellen.</translation>
    </message>
    <message>
        <source>%1 can render tissue up to %2 N/mm here.</source>
        <translation>%1 kann hier Gewebe bis %2 N/mm darstellen.</translation>
    </message>
    <message>
        <source> This is the rating of the manufacturer.</source>
        <translation> Das ist die Angabe des Herstellers.</translation>
    </message>
    <message>
        <source> The force is delayed by %1 ms; stiffer tissue could make the device vibrate.</source>
        <translation> Die Kraft kommt %1 ms verzögert; bei steiferem Gewebe könnte das Gerät zittern.</translation>
    </message>
    <message>
        <source> 1 mm of the device is %1 mm of the scene; a smaller scale (Device panel) allows stiffer tissue.</source>
        <translation> 1 mm des Geräts ist %1 mm der Szene; ein kleinerer Maßstab (Bereich „Gerät“) erlaubt steiferes Gewebe.</translation>
    </message>
    <message>
        <source>%1 is set to %2 N/mm but feels like %3 N/mm, the maximum that %4 can render here%5.</source>
        <translation>%1 ist auf %2 N/mm eingestellt, fühlt sich aber wie %3 N/mm an, das Maximum, das %4 hier darstellen kann%5.</translation>
    </message>
    <message>
        <source> in addition to the surrounding layers</source>
        <translation> zusätzlich zu den umgebenden Schichten</translation>
    </message>
</context>
<context>
    <name>palpate::ui::Looks</name>
    <message>
        <source>Light</source>
        <translation>Hell</translation>
    </message>
    <message>
        <source>Dark text on light panels</source>
        <translation>Dunkle Schrift auf hellen Feldern</translation>
    </message>
    <message>
        <source>Dark</source>
        <translation>Dunkel</translation>
    </message>
    <message>
        <source>Light text on dark panels, for a dark room</source>
        <translation>Helle Schrift auf dunklen Feldern, für einen dunklen Raum</translation>
    </message>
    <message>
        <source>High contrast, on black</source>
        <translation>Hoher Kontrast, auf Schwarz</translation>
    </message>
    <message>
        <source>High contrast, on white</source>
        <translation>Hoher Kontrast, auf Weiß</translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation>%1 %</translation>
    </message>
    <message>
        <source>Same as system</source>
        <translation>Wie das System</translation>
    </message>
    <message>
        <source>Light or dark, following the system</source>
        <translation>Hell oder dunkel, wie das System</translation>
    </message>
    <message>
        <source>White text on black, with visible edges</source>
        <translation>Weiße Schrift auf Schwarz, mit sichtbaren Kanten</translation>
    </message>
    <message>
        <source>Black text on white, with visible edges</source>
        <translation>Schwarze Schrift auf Weiß, mit sichtbaren Kanten</translation>
    </message>
    <message>
        <source>Text size of the system</source>
        <translation>Schriftgröße des Systems</translation>
    </message>
    <message>
        <source>Text size in panels and in the view</source>
        <translation>Schriftgröße in den Bereichen und in der Ansicht</translation>
    </message>
</context>
<context>
    <name>palpate::ui::LumpMaps</name>
    <message>
        <source>No lump was found inside a closed organ.</source>
        <translation>In keinem geschlossenen Organ wurde ein Knoten gefunden.</translation>
    </message>
    <message>
        <source>Computing how lumps in %1 feel; simulated as layers until then</source>
        <translation>Berechne, wie sich Knoten in %1 anfühlen; bis dahin als Schichten simuliert</translation>
    </message>
    <message>
        <source>Palpability of %1</source>
        <translation>Tastbarkeit von %1</translation>
    </message>
    <message>
        <source>The stiffness ratio of %2 to %1 is unknown, so palpability is not judged. Enter a ratio under What can be felt (B) or choose a published one.</source>
        <translation>Das Steifigkeitsverhältnis von %2 zu %1 ist unbekannt, daher wird die Tastbarkeit nicht beurteilt. Unter „Was tastbar ist“ (B) einen Wert eingeben oder einen veröffentlichten wählen.</translation>
    </message>
    <message>
        <source>The computation of buried lumps was cancelled. Lumps are simulated as layers until the scene changes.</source>
        <translation>Die Berechnung verborgener Knoten wurde abgebrochen. Knoten werden als Schichten simuliert, bis sich die Szene ändert.</translation>
    </message>
    <message>
        <source>The computation of palpability was cancelled.</source>
        <translation>Die Berechnung der Tastbarkeit wurde abgebrochen.</translation>
    </message>
    <message>
        <source>%1 lumps were left out.</source>
        <translation>%1 Knoten wurden ausgelassen.</translation>
    </message>
    <message>
        <source>%1 was left out: %2.</source>
        <translation>%1 wurde ausgelassen: %2.</translation>
    </message>
</context>
<context>
    <name>palpate::ui::MapDisplay</name>
    <message>
        <source>Young&apos;s modulus, kPa</source>
        <translation>Elastizitätsmodul, kPa</translation>
    </message>
    <message>
        <source>shear modulus, kPa</source>
        <translation>Schubmodul, kPa</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>damping, N·s/mm</source>
        <translation>Dämpfung, N·s/mm</translation>
    </message>
    <message>
        <source>friction, relative to the tissue</source>
        <translation>Reibung, relativ zum Gewebe</translation>
    </message>
    <message>
        <source>felt stiffness, N/mm</source>
        <translation>gefühlte Steifigkeit, N/mm</translation>
    </message>
    <message>
        <source>felt stiffness, relative to the law</source>
        <translation>gefühlte Steifigkeit, relativ zum Gesetz</translation>
    </message>
    <message>
        <source>%1: no data</source>
        <translation>%1: keine Daten</translation>
    </message>
    <message>
        <source>no data</source>
        <translation>keine Daten</translation>
    </message>
</context>
<context>
    <name>palpate::ui::MapEditor</name>
    <message>
        <source>Map</source>
        <translation>Karte</translation>
    </message>
    <message>
        <source>By name</source>
        <translation>Nach Namen</translation>
    </message>
    <message>
        <source>None</source>
        <translation>Keine</translation>
    </message>
    <message>
        <source>Stiffness</source>
        <translation>Steifigkeit</translation>
    </message>
    <message>
        <source>Friction</source>
        <translation>Reibung</translation>
    </message>
    <message>
        <source>Shear modulus, kPa</source>
        <translation>Schubmodul, kPa</translation>
    </message>
    <message>
        <source>Young&apos;s modulus, kPa</source>
        <translation>Elastizitätsmodul, kPa</translation>
    </message>
    <message>
        <source>Contact radius in mm</source>
        <translation>Kontaktradius in mm</translation>
    </message>
    <message>
        <source> mm</source>
        <translation> mm</translation>
    </message>
    <message>
        <source>Contact radius</source>
        <translation>Kontaktradius</translation>
    </message>
    <message>
        <source>to</source>
        <translation>bis</translation>
    </message>
    <message>
        <source>Show</source>
        <translation>Zeigen</translation>
    </message>
    <message>
        <source>Volume</source>
        <translation>Volumen</translation>
    </message>
    <message>
        <source>Volumes (*.vti *.mha *.mhd *.nrrd *.nhdr *.nii *.nii.gz);;All files (*)</source>
        <translation>Volumen (*.vti *.mha *.mhd *.nrrd *.nhdr *.nii *.nii.gz);;Alle Dateien (*)</translation>
    </message>
    <message>
        <source>Nothing</source>
        <translation>Nichts</translation>
    </message>
    <message>
        <source>Volume…</source>
        <translation>Volumen…</translation>
    </message>
    <message>
        <source>Own colour</source>
        <translation>Eigene Farbe</translation>
    </message>
    <message>
        <source>%1 varies by %2.</source>
        <translation>%1 variiert nach %2.</translation>
    </message>
    <message>
        <source>Variation of the tissue over the surface</source>
        <translation>Änderung des Gewebes über die Oberfläche</translation>
    </message>
    <message>
        <source>Manual</source>
        <translation>Manuell</translation>
    </message>
    <message>
        <source>Mesh arrays with a known name, such as StiffnessScale</source>
        <translation>Felder des Netzes mit bekanntem Namen, wie StiffnessScale</translation>
    </message>
    <message>
        <source>Property</source>
        <translation>Eigenschaft</translation>
    </message>
    <message>
        <source>Tissue property that varies</source>
        <translation>Gewebeeigenschaft, die variiert</translation>
    </message>
    <message>
        <source>Damping</source>
        <translation>Dämpfung</translation>
    </message>
    <message>
        <source>Source</source>
        <translation>Quelle</translation>
    </message>
    <message>
        <source>Mesh array or volume with the values</source>
        <translation>Feld des Netzes oder Volumen mit den Werten</translation>
    </message>
    <message>
        <source>Unit</source>
        <translation>Einheit</translation>
    </message>
    <message>
        <source>Meaning of the numbers. Shear modulus and Young&apos;s modulus differ by a factor of three; check the scanner manual</source>
        <translation>Bedeutung der Zahlen. Schub- und Elastizitätsmodul unterscheiden sich um den Faktor drei; siehe Handbuch des Scanners</translation>
    </message>
    <message>
        <source>choose…</source>
        <translation>auswählen…</translation>
    </message>
    <message>
        <source>Relative to the tissue</source>
        <translation>Relativ zum Gewebe</translation>
    </message>
    <message>
        <source>Stiffness, N/mm</source>
        <translation>Steifigkeit, N/mm</translation>
    </message>
    <message>
        <source>Radius of the finger contact; stiffness = 8 × radius × shear modulus</source>
        <translation>Radius des Fingerkontakts; Steifigkeit = 8 × Radius × Schubmodul</translation>
    </message>
    <message>
        <source>Limit the values</source>
        <translation>Werte begrenzen</translation>
    </message>
    <message>
        <source>Values outside the range are set to the nearest limit</source>
        <translation>Werte außerhalb des Bereichs werden auf die nächste Grenze gesetzt</translation>
    </message>
    <message>
        <source>Minimum</source>
        <translation>Minimum</translation>
    </message>
    <message>
        <source>Maximum</source>
        <translation>Maximum</translation>
    </message>
    <message>
        <source>Map status</source>
        <translation>Zustand der Karte</translation>
    </message>
    <message>
        <source>Colours the structure by value, with a legend</source>
        <translation>Färbt die Struktur nach Werten, mit Legende</translation>
    </message>
    <message>
        <source>Choose the unit of %1: shear modulus and Young&apos;s modulus differ by a factor of three.</source>
        <translation>Wählen Sie die Einheit von %1: Schub- und Elastizitätsmodul unterscheiden sich um den Faktor drei.</translation>
    </message>
    <message>
        <source>%1: %2 of %3 places have no value. The tissue value is used there.</source>
        <translation>%1: %2 von %3 Stellen haben keinen Wert. Dort gilt der Wert des Gewebes.</translation>
    </message>
</context>
<context>
    <name>palpate::ui::MapWarnings</name>
    <message>
        <source>(%1; %2; %3) mm</source>
        <translation>(%1; %2; %3) mm</translation>
    </message>
    <message>
        <source>%1: the effect of the lumps below changes too abruptly for the %2 at %3.</source>
        <translation>%1: Die Wirkung der Knoten darunter ändert sich bei %3 zu abrupt für das Gerät „%2“.</translation>
    </message>
    <message>
        <source>%1: the stiffness map changes too abruptly for the %2 at %3.</source>
        <translation>%1: Die Steifigkeitskarte ändert sich bei %3 zu abrupt für das Gerät „%2“.</translation>
    </message>
    <message>
        <source>The sideways force jumps by %1 N there and can make the hand oscillate by %2 mm.</source>
        <translation>Die Kraft zur Seite springt dort um %1 N und kann die Hand um %2 mm schwingen lassen.</translation>
    </message>
    <message>
        <source>Add friction to the tissue, or use a mesh with shorter edges there.</source>
        <translation>Dem Gewebe Reibung geben oder ein Netz mit dort kürzeren Kanten verwenden.</translation>
    </message>
    <message>
        <source>Spread the step over a longer distance, smooth both ends, or add friction to the tissue.</source>
        <translation>Die Stufe über eine längere Strecke verteilen, ihre Enden abrunden oder dem Gewebe Reibung geben.</translation>
    </message>
</context>
<context>
    <name>palpate::ui::MarginOverlay</name>
    <message>
        <source>%1
to %2,
share of its area</source>
        <translation>%1
bis %2,
Anteil der Fläche</translation>
    </message>
    <message>
        <source>Distance</source>
        <translation>Abstand</translation>
    </message>
</context>
<context>
    <name>palpate::ui::MessageBar</name>
    <message>
        <source> … and %1 more lines (F4)</source>
        <translation> … und %1 weitere Zeilen (F4)</translation>
    </message>
    <message>
        <source>Show the list of messages (F4)</source>
        <translation>Die Liste der Meldungen zeigen (F4)</translation>
    </message>
    <message>
        <source>1 older message (F4 shows all)</source>
        <translation>1 ältere Meldung (F4 zeigt alle)</translation>
    </message>
    <message>
        <source>%1 older messages (F4 shows all)</source>
        <translation>%1 ältere Meldungen (F4 zeigt alle)</translation>
    </message>
</context>
<context>
    <name>palpate::ui::MessageList</name>
    <message>
        <source>Messages</source>
        <translation>Meldungen</translation>
    </message>
    <message>
        <source>Copy (Ctrl+C)</source>
        <translation>Kopieren (Strg+C)</translation>
    </message>
</context>
<context>
    <name>palpate::ui::MessageRow</name>
    <message>
        <source>Close this message</source>
        <translation>Diese Meldung schließen</translation>
    </message>
    <message>
        <source>Close this message; still listed under Messages (F4)</source>
        <translation>Diese Meldung schließen; sie bleibt in der Liste der Meldungen (F4)</translation>
    </message>
</context>
<context>
    <name>palpate::ui::Messages</name>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>Warning</source>
        <translation>Warnung</translation>
    </message>
    <message>
        <source>Error</source>
        <translation>Fehler</translation>
    </message>
    <message>
        <source>Offer</source>
        <translation>Angebot</translation>
    </message>
    <message>
        <source>Information</source>
        <translation>Information</translation>
    </message>
</context>
<context>
    <name>palpate::ui::MotionPanel</name>
    <message>
        <source>Let the tissue move, or stop it where it is</source>
        <translation>Das Gewebe bewegen lassen oder anhalten, wo es ist</translation>
    </message>
    <message>
        <source>Hold breath</source>
        <translation>Atem anhalten</translation>
    </message>
    <message>
        <source>Hold breathing tissue where it is; pulses and tracked poses go on</source>
        <translation>Atmendes Gewebe anhalten, wo es ist; Pulse und verfolgte Lagen laufen weiter</translation>
    </message>
    <message>
        <source> ×</source>
        <translation> ×</translation>
    </message>
    <message>
        <source>Rate of the motion</source>
        <translation>Tempo der Bewegung</translation>
    </message>
    <message>
        <source>Speed of all motions; 1 is that of the scene file</source>
        <translation>Geschwindigkeit aller Bewegungen; 1 ist die der Szenendatei</translation>
    </message>
    <message>
        <source>Rate</source>
        <translation>Rate</translation>
    </message>
    <message>
        <source>Amplitude of the breath</source>
        <translation>Amplitude der Atmung</translation>
    </message>
    <message>
        <source>Share of the displacement of the scene file; at 0 % breathing tissue rests</source>
        <translation>Anteil der Verschiebung der Szenendatei; bei 0 % ruht atmendes Gewebe</translation>
    </message>
    <message>
        <source>Amplitude</source>
        <translation>Amplitude</translation>
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
        <source>%1 %</source>
        <translation>%1 %</translation>
    </message>
</context>
<context>
    <name>palpate::ui::PalpationController</name>
    <message>
        <source>camera</source>
        <translation>Kamera</translation>
    </message>
    <message>
        <source>presses %1 mm</source>
        <translation>drückt %1 mm</translation>
    </message>
    <message>
        <source>pressing %1 mm, slid aside</source>
        <translation>drückt %1 mm, zur Seite gerutscht</translation>
    </message>
    <message>
        <source>pressing %1 mm</source>
        <translation>drückt %1 mm</translation>
    </message>
    <message>
        <source>pressing %1 of %2 mm</source>
        <translation>drückt %1 von %2 mm</translation>
    </message>
    <message>
        <source>presses up to %1 N</source>
        <translation>drückt bis %1 N</translation>
    </message>
    <message>
        <source>%1 mm is the maximum depth, limited by the size of the scene.</source>
        <translation>%1 mm ist die größte Tiefe, begrenzt durch die Größe der Szene.</translation>
    </message>
    <message>
        <source>%1 N is the maximum press force.</source>
        <translation>%1 N ist die größte Druckkraft.</translation>
    </message>
    <message>
        <source>No palpable structure is in view.</source>
        <translation>In der Ansicht ist keine tastbare Struktur.</translation>
    </message>
    <message>
        <source>target %1 of %2 N, actual %3 N, %4 mm</source>
        <translation>Soll %1 von %2 N, ist %3 N, %4 mm</translation>
    </message>
</context>
<context>
    <name>palpate::ui::Playback</name>
    <message>
        <source>structure %1</source>
        <translation>Struktur %1</translation>
    </message>
    <message>
        <source>A: %1, B: %2</source>
        <translation>A: %1, B: %2</translation>
    </message>
</context>
<context>
    <name>palpate::ui::PointedStructure</name>
    <message>
        <source>image: %1</source>
        <translation>Bild: %1</translation>
    </message>
    <message>
        <source>%1 · %2</source>
        <translation>%1 · %2</translation>
    </message>
</context>
<context>
    <name>palpate::ui::RecordedTouch</name>
    <message>
        <source>%1 ends at %2 s because the disk was full. Later palpation was not recorded.</source>
        <translation>%1 endet bei %2 s, weil der Datenträger voll war. Spätere Palpation wurde nicht aufgezeichnet.</translation>
    </message>
    <message>
        <source>%1 ends at %2 s because of a disk write error. Later palpation was not recorded.</source>
        <translation>%1 endet bei %2 s wegen eines Schreibfehlers des Datenträgers. Spätere Palpation wurde nicht aufgezeichnet.</translation>
    </message>
    <message>
        <source>%1 was not closed (crash or full disk) and ends at %2 s. Later palpation was not recorded.</source>
        <translation>%1 wurde nicht abgeschlossen (Absturz oder voller Datenträger) und endet bei %2 s. Spätere Palpation wurde nicht aufgezeichnet.</translation>
    </message>
    <message>
        <source>%1: %2 samples were lost during recording because the disk was too slow.</source>
        <translation>%1: %2 Messpunkte gingen bei der Aufzeichnung verloren, weil der Datenträger zu langsam war.</translation>
    </message>
    <message numerus="yes">
        <source>%1 is damaged or was changed after recording: %n part(s) do not match their checksums and are left out. &quot;palpate session verify&quot; names the first part.</source>
        <translation>
            <numerusform>%1 ist beschädigt oder wurde nach der Aufnahme geändert: %n Abschnitt passt nicht zu seiner Prüfsumme und fehlt. „palpate session verify“ nennt den ersten Abschnitt.</numerusform>
            <numerusform>%1 ist beschädigt oder wurde nach der Aufnahme geändert: %n Abschnitte passen nicht zu ihren Prüfsummen und fehlen. „palpate session verify“ nennt den ersten Abschnitt.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>palpate::ui::SceneDistances</name>
    <message>
        <source>Measuring distances</source>
        <translation>Abstände werden gemessen</translation>
    </message>
    <message>
        <source>Measuring distances was cancelled.</source>
        <translation>Das Messen der Abstände wurde abgebrochen.</translation>
    </message>
</context>
<context>
    <name>palpate::ui::SceneLoader</name>
    <message>
        <source>Nothing to open.</source>
        <translation>Nichts zu öffnen.</translation>
    </message>
    <message>
        <source>Reading %1</source>
        <translation>Lese %1</translation>
    </message>
    <message>
        <source>Preparing for touch</source>
        <translation>Bereite das Tasten vor</translation>
    </message>
    <message>
        <source>, </source>
        <translation>, </translation>
    </message>
    <message>
        <source>view</source>
        <translation>Ansicht</translation>
    </message>
    <message>
        <source>unknown fields</source>
        <translation>unbekannte Felder</translation>
    </message>
    <message>
        <source>%1: opened together with another scene; not imported: %2</source>
        <translation>%1: zusammen mit einer anderen Szene geöffnet; nicht übernommen: %2</translation>
    </message>
    <message>
        <source>Finding structures inside others</source>
        <translation>Enthaltene Strukturen werden gesucht</translation>
    </message>
    <message>
        <source>Drawing the scene</source>
        <translation>Szene wird gezeichnet</translation>
    </message>
</context>
<context>
    <name>palpate::ui::SectionBar</name>
    <message>
        <source>Axial</source>
        <translation>Axial</translation>
    </message>
    <message>
        <source>Coronal</source>
        <translation>Koronal</translation>
    </message>
    <message>
        <source>Sagittal</source>
        <translation>Sagittal</translation>
    </message>
    <message>
        <source>Free</source>
        <translation>Frei</translation>
    </message>
    <message>
        <source>Direction of the section</source>
        <translation>Richtung des Schnitts</translation>
    </message>
    <message>
        <source>Direction of the section; Free faces the viewer when chosen</source>
        <translation>Richtung des Schnitts; „Frei“ zeigt beim Auswählen zum Betrachter</translation>
    </message>
    <message>
        <source> mm</source>
        <translation> mm</translation>
    </message>
    <message>
        <source>Position of the section</source>
        <translation>Position des Schnitts</translation>
    </message>
    <message>
        <source>Position from the origin of the coordinates towards left, back or head. Shift and the wheel over the view move the section</source>
        <translation>Position vom Ursprung der Koordinaten nach links, hinten oder kopfwärts. Umschalt und das Rad über der Ansicht bewegen den Schnitt</translation>
    </message>
    <message>
        <source>Show the other side of the section</source>
        <translation>Die andere Seite des Schnitts zeigen</translation>
    </message>
    <message>
        <source>End the section</source>
        <translation>Schnitt beenden</translation>
    </message>
    <message>
        <source>Image</source>
        <translation>Bild</translation>
    </message>
    <message>
        <source>Window</source>
        <translation>Fenster</translation>
    </message>
    <message>
        <source>Range of numbers from black to white</source>
        <translation>Bereich der Werte von Schwarz bis Weiß</translation>
    </message>
    <message>
        <source>Level</source>
        <translation>Lage</translation>
    </message>
    <message>
        <source>Number shown in medium grey</source>
        <translation>Wert, der mittelgrau erscheint</translation>
    </message>
</context>
<context>
    <name>palpate::ui::SessionPanel</name>
    <message>
        <source>Position and length</source>
        <translation>Position und Länge</translation>
    </message>
    <message>
        <source>Position / length [min:s]</source>
        <translation>Position / Länge [min:s]</translation>
    </message>
    <message>
        <source>%1 ×</source>
        <translation>%1 ×</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>Tempo</translation>
    </message>
    <message>
        <source>No recording yet. Record one with R, or open a .palpate file.</source>
        <translation>Noch keine Aufzeichnung. Mit R eine aufnehmen oder eine .palpate-Datei öffnen.</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <translation>%1, %2</translation>
    </message>
    <message>
        <source>%1 late, %2 lost</source>
        <translation>%1 verspätet, %2 verloren</translation>
    </message>
    <message>
        <source>Playback speed; 1 × is real time</source>
        <translation>Wiedergabetempo; 1 × ist Echtzeit</translation>
    </message>
    <message>
        <source>Force timeline of the second recording</source>
        <translation>Kraftverlauf der zweiten Aufnahme</translation>
    </message>
    <message>
        <source>A %1, B %2</source>
        <translation>A %1, B %2</translation>
    </message>
</context>
<context>
    <name>palpate::ui::StructureList</name>
    <message>
        <source>Structures</source>
        <translation>Strukturen</translation>
    </message>
    <message>
        <source>Filter by name</source>
        <translation>Nach Namen filtern</translation>
    </message>
    <message>
        <source>Filter the structures by name</source>
        <translation>Die Strukturen nach Namen filtern</translation>
    </message>
    <message>
        <source>Order and groups of the list</source>
        <translation>Reihenfolge und Gruppen der Liste</translation>
    </message>
    <message>
        <source>Order</source>
        <translation>Reihenfolge</translation>
    </message>
    <message>
        <source>As opened</source>
        <translation>Wie geöffnet</translation>
    </message>
    <message>
        <source>By name</source>
        <translation>Nach Namen</translation>
    </message>
    <message>
        <source>By tissue, softest first</source>
        <translation>Nach Gewebe, weichstes zuerst</translation>
    </message>
    <message>
        <source>By layer, outermost first</source>
        <translation>Nach Schicht, äußerste zuerst</translation>
    </message>
    <message>
        <source>Groups</source>
        <translation>Gruppen</translation>
    </message>
    <message>
        <source>None</source>
        <translation>Keine</translation>
    </message>
    <message>
        <source>By file or folder</source>
        <translation>Nach Datei oder Ordner</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 von %2</translation>
    </message>
    <message>
        <source>List only structures with these words in the name (Ctrl+F); Esc lists all</source>
        <translation>Nur Strukturen mit diesen Wörtern im Namen auflisten (Strg+F); Esc listet alle auf</translation>
    </message>
    <message>
        <source>By layer</source>
        <translation>Nach Schicht</translation>
    </message>
    <message>
        <source>By anatomy</source>
        <translation>Nach Anatomie</translation>
    </message>
    <message>
        <source>Targets of the exercise can be felt, but are neither drawn nor named until the exercise ends</source>
        <translation>Ziele der Übung sind tastbar, werden aber bis zum Ende der Übung weder gezeichnet noch benannt</translation>
    </message>
    <message numerus="yes">
        <source>%n hidden target(s)</source>
        <translation>
            <numerusform>%n verborgenes Ziel</numerusform>
            <numerusform>%n verborgene Ziele</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>palpate::ui::StructureModel</name>
    <message>
        <source>Change %1</source>
        <translation>%1 ändern</translation>
    </message>
    <message>
        <source>outermost</source>
        <translation>außen</translation>
    </message>
    <message>
        <source>below %1</source>
        <translation>unter %1</translation>
    </message>
    <message>
        <source>Structure</source>
        <translation>Struktur</translation>
    </message>
    <message>
        <source>Name and colour</source>
        <translation>Name und Farbe</translation>
    </message>
    <message>
        <source>Remove %1</source>
        <translation>%1 entfernen</translation>
    </message>
    <message>
        <source>Remove %1 structures</source>
        <translation>%1 Strukturen entfernen</translation>
    </message>
    <message>
        <source>Rename %1</source>
        <translation>%1 umbenennen</translation>
    </message>
    <message>
        <source>The mesh is open: feels like a sheet</source>
        <translation>Das Netz ist offen: fühlt sich an wie ein Blatt</translation>
    </message>
    <message>
        <source>Part of the mesh is open: feels like a sheet there</source>
        <translation>Ein Teil des Netzes ist offen: fühlt sich dort an wie ein Blatt</translation>
    </message>
    <message>
        <source>through %1</source>
        <translation>durch %1 hindurch</translation>
    </message>
    <message>
        <source>Turn %1 around</source>
        <translation>%1 umdrehen</translation>
    </message>
    <message>
        <source>Turn %1 surfaces around</source>
        <translation>%1 Oberflächen umdrehen</translation>
    </message>
    <message>
        <source>Smooth %1</source>
        <translation>%1 glätten</translation>
    </message>
    <message>
        <source>Smooth %1 surfaces</source>
        <translation>%1 Oberflächen glätten</translation>
    </message>
    <message>
        <source>The surface is smoothed: moved by at most %1 mm</source>
        <translation>Die Oberfläche ist geglättet: höchstens um %1 mm verschoben</translation>
    </message>
    <message>
        <source>The surface is smoothed: moved by at most %1 mm, volume %2 %</source>
        <translation>Die Oberfläche ist geglättet: höchstens um %1 mm verschoben, Volumen %2 %</translation>
    </message>
    <message>
        <source>%1 below surface</source>
        <translation>%1 unter der Oberfläche</translation>
    </message>
    <message>
        <source>The surface has steps of %1 × %2 × %3 mm voxels, which can be felt</source>
        <translation>Die Oberfläche hat Stufen von Voxeln mit %1 × %2 × %3 mm, die zu fühlen sind</translation>
    </message>
    <message>
        <source>The mesh is inside out: palpable only from inside</source>
        <translation>Das Netz ist umgestülpt: nur von innen tastbar</translation>
    </message>
    <message>
        <source>Mesh defects were repaired</source>
        <translation>Fehler des Netzes wurden behoben</translation>
    </message>
    <message>
        <source>Some edges are shared by more than two triangles</source>
        <translation>Manche Kanten gehören zu mehr als zwei Dreiecken</translation>
    </message>
    <message>
        <source>%1 is visible. Click to hide; hidden structures cannot be felt.</source>
        <translation>%1 ist sichtbar. Zum Verbergen klicken; verborgene Strukturen sind nicht tastbar.</translation>
    </message>
    <message>
        <source>%1 is hidden. Click to show.</source>
        <translation>%1 ist verborgen. Zum Zeigen klicken.</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <translation>%1, %2</translation>
    </message>
    <message>
        <source>%1
%2 triangles
Depth order: %3</source>
        <translation>%1
%2 Dreiecke
Tiefenlage: %3</translation>
    </message>
    <message>
        <source>%1 is palpable. Click to let the hand pass through.</source>
        <translation>%1 ist tastbar. Klicken, um die Hand hindurchzulassen.</translation>
    </message>
    <message>
        <source>The hand passes through %1. Click to make palpable.</source>
        <translation>Die Hand geht durch %1 hindurch. Klicken, um tastbar zu machen.</translation>
    </message>
    <message>
        <source>Visible</source>
        <translation>Sichtbar</translation>
    </message>
    <message>
        <source>Notes on the mesh</source>
        <translation>Hinweise zum Netz</translation>
    </message>
    <message>
        <source>Palpable</source>
        <translation>Tastbar</translation>
    </message>
    <message>
        <source>The surface is not smoothed: it is too small</source>
        <translation>Die Oberfläche ist nicht geglättet: sie ist zu klein</translation>
    </message>
    <message>
        <source>Close the holes of %1</source>
        <translation>Löcher von %1 schließen</translation>
    </message>
    <message>
        <source>Close the holes of %1 surfaces</source>
        <translation>Löcher von %1 Oberflächen schließen</translation>
    </message>
    <message>
        <source>Reopen the holes of %1</source>
        <translation>Löcher von %1 wieder öffnen</translation>
    </message>
    <message>
        <source>Reopen the holes of %1 surfaces</source>
        <translation>Löcher von %1 Oberflächen wieder öffnen</translation>
    </message>
    <message>
        <source>A hole of %1 mm was closed</source>
        <translation>Ein Loch von %1 mm wurde geschlossen</translation>
    </message>
    <message>
        <source>%1 holes of up to %2 mm were closed</source>
        <translation>%1 Löcher bis %2 mm wurden geschlossen</translation>
    </message>
    <message>
        <source>Mesh of %1:
• %2
Details: %3</source>
        <translation>Netz von %1:
• %2
Einzelheiten: %3</translation>
    </message>
    <message>
        <source>unnamed structure</source>
        <translation>unbenannte Struktur</translation>
    </message>
</context>
<context>
    <name>palpate::ui::StructurePanel</name>
    <message>
        <source>Colour of the structure</source>
        <translation>Farbe der Struktur</translation>
    </message>
    <message>
        <source>Colour</source>
        <translation>Farbe</translation>
    </message>
    <message>
        <source>Opacity in per cent</source>
        <translation>Deckkraft in Prozent</translation>
    </message>
    <message>
        <source>Opacity</source>
        <translation>Deckkraft</translation>
    </message>
    <message>
        <source>%1 in %2</source>
        <translation>%1 in %2</translation>
    </message>
    <message>
        <source>Tissue</source>
        <translation>Gewebe</translation>
    </message>
    <message>
        <source>Friction</source>
        <translation>Reibung</translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation>%1 %</translation>
    </message>
    <message>
        <source>No structure selected</source>
        <translation>Keine Struktur gewählt</translation>
    </message>
    <message>
        <source>Source: %1</source>
        <translation>Quelle: %1</translation>
    </message>
    <message>
        <source>Colour of %1</source>
        <translation>Farbe von %1</translation>
    </message>
    <message>
        <source>Show all</source>
        <translation>Alle zeigen</translation>
    </message>
    <message>
        <source>Very soft organ</source>
        <translation>Sehr weiches Organ</translation>
    </message>
    <message>
        <source>Soft organ</source>
        <translation>Weiches Organ</translation>
    </message>
    <message>
        <source>Firm organ</source>
        <translation>Festes Organ</translation>
    </message>
    <message>
        <source>Firm lump</source>
        <translation>Fester Knoten</translation>
    </message>
    <message>
        <source>Hard lump</source>
        <translation>Harter Knoten</translation>
    </message>
    <message>
        <source>Bone</source>
        <translation>Knochen</translation>
    </message>
    <message>
        <source>Liver, healthy (2.3 kPa)</source>
        <translation>Leber, gesund (2,3 kPa)</translation>
    </message>
    <message>
        <source>Liver, fibrotic (5.9 kPa)</source>
        <translation>Leber, fibrotisch (5,9 kPa)</translation>
    </message>
    <message>
        <source>Liver, malignant (10.1 kPa)</source>
        <translation>Leber, maligne (10,1 kPa)</translation>
    </message>
    <message>
        <source>Liver, stiffer with depth</source>
        <translation>Leber, steifer mit der Tiefe</translation>
    </message>
    <message>
        <source>None</source>
        <translation>Keine</translation>
    </message>
    <message>
        <source>Change %1 structures</source>
        <translation>%1 Strukturen ändern</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>%1 structures</source>
        <translation>%1 Strukturen</translation>
    </message>
    <message>
        <source>Rename…</source>
        <translation>Umbenennen…</translation>
    </message>
    <message>
        <source>Remove from the scene</source>
        <translation>Aus der Szene entfernen</translation>
    </message>
    <message>
        <source>Custom</source>
        <translation>Eigene Werte</translation>
    </message>
    <message>
        <source>Change %1</source>
        <translation>%1 ändern</translation>
    </message>
    <message>
        <source>as a layer, %1</source>
        <translation>als Schicht, %1</translation>
    </message>
    <message>
        <source>%1 (felt from above)</source>
        <translation>%1 (von oben gefühlt)</translation>
    </message>
    <message>
        <source>through %1 (felt from above)</source>
        <translation>durch %1 hindurch (von oben gefühlt)</translation>
    </message>
    <message>
        <source>As in the file</source>
        <translation>Wie in der Datei</translation>
    </message>
    <message>
        <source>Smoothed</source>
        <translation>Geglättet</translation>
    </message>
    <message>
        <source>Surface</source>
        <translation>Oberfläche</translation>
    </message>
    <message>
        <source>Turn around</source>
        <translation>Umdrehen</translation>
    </message>
    <message>
        <source>Kidney (5.0 kPa)</source>
        <translation>Niere (5,0 kPa)</translation>
    </message>
    <message>
        <source>Spleen (2.9 kPa)</source>
        <translation>Milz (2,9 kPa)</translation>
    </message>
    <message>
        <source>Pancreas (4.8 kPa)</source>
        <translation>Pankreas (4,8 kPa)</translation>
    </message>
    <message>
        <source>Thyroid (11.0 kPa)</source>
        <translation>Schilddrüse (11,0 kPa)</translation>
    </message>
    <message>
        <source>Salivary gland (10.9 kPa)</source>
        <translation>Speicheldrüse (10,9 kPa)</translation>
    </message>
    <message>
        <source>Muscle at rest (11.1 kPa)</source>
        <translation>Ruhender Muskel (11,1 kPa)</translation>
    </message>
    <message>
        <source>Tendon (51.5 kPa)</source>
        <translation>Sehne (51,5 kPa)</translation>
    </message>
    <message>
        <source>Prostate (17.0 kPa)</source>
        <translation>Prostata (17,0 kPa)</translation>
    </message>
    <message>
        <source>Breast (3.2 kPa)</source>
        <translation>Brust (3,2 kPa)</translation>
    </message>
    <message>
        <source>Lymph node</source>
        <translation>Lymphknoten</translation>
    </message>
    <message>
        <source>Opacity [%]; at lower values, structures behind show through</source>
        <translation>Deckkraft [%]; bei kleineren Werten scheinen Strukturen dahinter durch</translation>
    </message>
    <message>
        <source>%1 [%2]: %3</source>
        <translation>%1 [%2]: %3</translation>
    </message>
    <message>
        <source>Tissue preset</source>
        <translation>Gewebevorlage</translation>
    </message>
    <message>
        <source>Stability warning for the map</source>
        <translation>Stabilitätswarnung zur Karte</translation>
    </message>
    <message>
        <source>Friction preset</source>
        <translation>Reibungsvorlage</translation>
    </message>
    <message>
        <source>Effective stiffness</source>
        <translation>Wirksame Steifigkeit</translation>
    </message>
    <message>
        <source>Reason for rejecting the value</source>
        <translation>Grund der Ablehnung des Werts</translation>
    </message>
    <message>
        <source>Depth order, from outside</source>
        <translation>Tiefenlage, von außen</translation>
    </message>
    <message>
        <source>Order in which a pressing hand meets the structures (Ctrl+Down, Ctrl+Up in the list)</source>
        <translation>Reihenfolge, in der eine drückende Hand auf die Strukturen trifft (Strg+↓, Strg+↑ in der Liste)</translation>
    </message>
    <message>
        <source>Depth order</source>
        <translation>Tiefenlage</translation>
    </message>
    <message>
        <source>own surface, outermost</source>
        <translation>eigene Oberfläche, außen</translation>
    </message>
    <message>
        <source>%1 uses %2</source>
        <translation>%1 braucht %2</translation>
    </message>
    <message>
        <source>limited to at most %1 N/mm: the device can render %2 N/mm in total%3</source>
        <translation>begrenzt auf höchstens %1 N/mm: das Gerät kann insgesamt %2 N/mm darstellen%3</translation>
    </message>
    <message>
        <source>limited to %1 N/mm: the device can render %2 N/mm in total%3</source>
        <translation>begrenzt auf %1 N/mm: das Gerät kann insgesamt %2 N/mm darstellen%3</translation>
    </message>
    <message>
        <source>Invalid force law: %1.</source>
        <translation>Ungültiges Kraftgesetz: %1.</translation>
    </message>
    <message>
        <source>%1 N·s/mm is too much: the device can render at most %2 N·s/mm. Enter %2 N·s/mm or less.</source>
        <translation>%1 N·s/mm ist zu viel: Das Gerät kann höchstens %2 N·s/mm darstellen. Geben Sie %2 N·s/mm oder weniger ein.</translation>
    </message>
    <message>
        <source>%1 Of this, %2.</source>
        <translation>%1 Davon: %2.</translation>
    </message>
    <message>
        <source>%1 N/mm is too stiff. %2 Enter %3 N/mm or less.</source>
        <translation>%1 N/mm ist zu steif. %2 Geben Sie %3 N/mm oder weniger ein.</translation>
    </message>
    <message>
        <source>The force law is too steep: up to %1 N/mm. %2 Enter values with a slope of at most %3 N/mm.</source>
        <translation>Das Kraftgesetz ist zu steil: bis %1 N/mm. %2 Geben Sie Werte mit einer Steigung von höchstens %3 N/mm ein.</translation>
    </message>
    <message>
        <source>Show only the selection</source>
        <translation>Nur die Auswahl zeigen</translation>
    </message>
    <message>
        <source>Make only the selection palpable</source>
        <translation>Nur die Auswahl tastbar machen</translation>
    </message>
    <message>
        <source>Make all palpable</source>
        <translation>Alle tastbar machen</translation>
    </message>
    <message>
        <source>none, assumed values</source>
        <translation>keine, angenommene Werte</translation>
    </message>
    <message>
        <source>shear modulus from MR elastography (PMC2894569), for a fingertip of 5 mm radius</source>
        <translation>Schubmodul aus MR-Elastographie (PMC2894569), für eine Fingerkuppe von 5 mm Radius</translation>
    </message>
    <message>
        <source>Young&apos;s modulus from shear-wave ultrasound (Arda et al. 2011, AJR 197:532), for a fingertip of 5 mm radius</source>
        <translation>Elastizitätsmodul aus Scherwellen-Ultraschall (Arda et al. 2011, AJR 197:532), für eine Fingerkuppe von 5 mm Radius</translation>
    </message>
    <message>
        <source>Young&apos;s modulus from indentation (Urology 2010), for a fingertip of 5 mm radius</source>
        <translation>Elastizitätsmodul aus Eindruckversuchen (Urology 2010), für eine Fingerkuppe von 5 mm Radius</translation>
    </message>
    <message>
        <source>Young&apos;s modulus from indentation (Teixeira et al. 2023), for a fingertip of 5 mm radius</source>
        <translation>Elastizitätsmodul aus Eindruckversuchen (Teixeira et al. 2023), für eine Fingerkuppe von 5 mm Radius</translation>
    </message>
    <message>
        <source>assumed value below 22 kPa, the malignancy threshold of lymph nodes (2.71 m/s by shear-wave ultrasound)</source>
        <translation>angenommener Wert unter 22 kPa, der Malignitätsschwelle von Lymphknoten (2,71 m/s durch Scherwellen-Ultraschall)</translation>
    </message>
    <message>
        <source>shape after Carter et al. 2001 (exponential), assumed values</source>
        <translation>Form nach Carter et al. 2001 (exponentiell), angenommene Werte</translation>
    </message>
    <message>
        <source>Demo: ball on soft ground</source>
        <translation>Demo: Kugel auf weichem Grund</translation>
    </message>
    <message>
        <source>shape after Hertz 1882, assumed values</source>
        <translation>Form nach Hertz 1882, angenommene Werte</translation>
    </message>
    <message>
        <source>Demo: clicking button</source>
        <translation>Demo: klickender Knopf</translation>
    </message>
    <message>
        <source>Wet (0.05, assumed)</source>
        <translation>Nass (0,05, angenommen)</translation>
    </message>
    <message>
        <source>Moist (0.15, assumed)</source>
        <translation>Feucht (0,15, angenommen)</translation>
    </message>
    <message>
        <source>Dry (0.40, assumed)</source>
        <translation>Trocken (0,40, angenommen)</translation>
    </message>
    <message>
        <source>Curved facets</source>
        <translation>Gekrümmte Facetten</translation>
    </message>
    <message>
        <source>Smoothed, curved facets</source>
        <translation>Geglättet, gekrümmte Facetten</translation>
    </message>
    <message>
        <source>Smoothing removes voxel steps for display and touch, moving the surface by at most half a voxel. Curved facets make coarse facets round; edges of more than 40° stay sharp. The file is not changed.</source>
        <translation>Das Glätten entfernt Voxelstufen für Anzeige und Tasten und verschiebt die Fläche um höchstens einen halben Voxel. Gekrümmte Facetten machen grobe Facetten rund; Kanten von mehr als 40° bleiben scharf. Die Datei wird nicht verändert.</translation>
    </message>
    <message>
        <source>%1 triangles, %2 MiB for touch</source>
        <translation>%1 Dreiecke, %2 MiB zum Tasten</translation>
    </message>
    <message>
        <source>Smoothing factor</source>
        <translation>Glättungsfaktor</translation>
    </message>
    <message>
        <source>Smoothing factor, from 0 (nearly none) to 1. A larger factor removes steps of thick slices, and changes the shape more</source>
        <translation>Glättungsfaktor von 0 (fast keine) bis 1. Ein größerer Faktor entfernt Stufen dicker Schichten und verändert die Form stärker</translation>
    </message>
    <message>
        <source>Smoothing</source>
        <translation>Glättung</translation>
    </message>
    <message>
        <source>Close the holes</source>
        <translation>Löcher schließen</translation>
    </message>
    <message>
        <source>Close the hole of %1 mm</source>
        <translation>Das Loch von %1 mm schließen</translation>
    </message>
    <message>
        <source>Close %1 holes of up to %2 mm</source>
        <translation>%1 Löcher bis %2 mm schließen</translation>
    </message>
    <message>
        <source>Reopen the holes</source>
        <translation>Löcher wieder öffnen</translation>
    </message>
    <message>
        <source>Feel</source>
        <translation>Tastgefühl</translation>
    </message>
    <message>
        <source>Appearance</source>
        <translation>Darstellung</translation>
    </message>
    <message>
        <source>Advanced</source>
        <translation>Erweitert</translation>
    </message>
    <message>
        <source>Maps are off until the exercise ends</source>
        <translation>Karten sind bis zum Ende der Übung aus</translation>
    </message>
</context>
<context>
    <name>palpate::ui::StructureTree</name>
    <message>
        <source>Other</source>
        <translation>Andere</translation>
    </message>
    <message>
        <source>%1 (%2)</source>
        <translation>%1 (%2)</translation>
    </message>
    <message>
        <source>Hide all of %1</source>
        <translation>Alle aus %1 verbergen</translation>
    </message>
    <message>
        <source>Show all of %1</source>
        <translation>Alle aus %1 zeigen</translation>
    </message>
    <message>
        <source>Let the hand pass through all of %1</source>
        <translation>Die Hand durch alle aus %1 lassen</translation>
    </message>
    <message>
        <source>Outermost</source>
        <translation>Zuäußerst</translation>
    </message>
    <message>
        <source>%1 below surface</source>
        <translation>%1 unter der Oberfläche</translation>
    </message>
    <message>
        <source>Make all of %1 palpable</source>
        <translation>Alle aus %1 tastbar machen</translation>
    </message>
    <message>
        <source>Lumps</source>
        <translation>Knoten</translation>
    </message>
    <message>
        <source>Organs</source>
        <translation>Organe</translation>
    </message>
    <message>
        <source>Vessels</source>
        <translation>Gefäße</translation>
    </message>
    <message>
        <source>Brain and nerves</source>
        <translation>Gehirn und Nerven</translation>
    </message>
    <message>
        <source>Bones</source>
        <translation>Knochen</translation>
    </message>
    <message>
        <source>Cartilage and tendons</source>
        <translation>Knorpel und Sehnen</translation>
    </message>
    <message>
        <source>Muscles</source>
        <translation>Muskeln</translation>
    </message>
    <message>
        <source>Skin and fat</source>
        <translation>Haut und Fett</translation>
    </message>
</context>
<context>
    <name>palpate::ui::TapeTool</name>
    <message>
        <source>Tape: click on two places, or touch a place and press T, then another. Esc ends.</source>
        <translation>Maßband: zwei Orte anklicken, oder einen Ort berühren und T drücken, dann einen zweiten. Esc beendet.</translation>
    </message>
    <message>
        <source>The tape is put away.</source>
        <translation>Das Maßband ist weggelegt.</translation>
    </message>
    <message>
        <source>Tape: click on a structure.</source>
        <translation>Maßband: klicken Sie auf eine Struktur.</translation>
    </message>
    <message>
        <source>Tape: first end set.</source>
        <translation>Maßband: erstes Ende gesetzt.</translation>
    </message>
    <message>
        <source>Tape: first end on %1.</source>
        <translation>Maßband: erstes Ende auf %1.</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
</context>
<context>
    <name>palpate::ui::TapesModel</name>
    <message>
        <source>Tape %1</source>
        <translation>Maßband %1</translation>
    </message>
    <message>
        <source>Measure %1</source>
        <translation>%1 messen</translation>
    </message>
    <message>
        <source>Delete %1</source>
        <translation>%1 löschen</translation>
    </message>
    <message>
        <source>Delete %1 tapes</source>
        <translation>%1 Maßbänder löschen</translation>
    </message>
    <message>
        <source>Tape</source>
        <translation>Maßband</translation>
    </message>
    <message>
        <source>Length</source>
        <translation>Länge</translation>
    </message>
    <message>
        <source>From</source>
        <translation>Von</translation>
    </message>
    <message>
        <source>To</source>
        <translation>Bis</translation>
    </message>
    <message>
        <source>Rename %1</source>
        <translation>%1 umbenennen</translation>
    </message>
    <message>
        <source>%1 mm</source>
        <translation>%1 mm</translation>
    </message>
</context>
<context>
    <name>palpate::ui::TouchChart</name>
    <message>
        <source>Chart of force and depth over the last ten seconds</source>
        <translation>Diagramm von Kraft und Tiefe über die letzten zehn Sekunden</translation>
    </message>
    <message>
        <source>Force [N] and depth [mm] over the last 10 s</source>
        <translation>Kraft [N] und Tiefe [mm] über die letzten 10 s</translation>
    </message>
    <message>
        <source>−10 s</source>
        <translation>−10 s</translation>
    </message>
    <message>
        <source>−5 s</source>
        <translation>−5 s</translation>
    </message>
    <message>
        <source>now</source>
        <translation>jetzt</translation>
    </message>
    <message>
        <source>Force [N]</source>
        <translation>Kraft [N]</translation>
    </message>
    <message>
        <source>Depth [mm]</source>
        <translation>Tiefe [mm]</translation>
    </message>
    <message>
        <source>along the surface</source>
        <translation>entlang der Oberfläche</translation>
    </message>
    <message>
        <source>no contact yet</source>
        <translation>noch kein Kontakt</translation>
    </message>
    <message>
        <source>now %1 N, %2 mm deep; maximum %3 N, %4 mm</source>
        <translation>jetzt %1 N, %2 mm tief; Maximum %3 N, %4 mm</translation>
    </message>
</context>
<context>
    <name>palpate::ui::TouchMap</name>
    <message>
        <source>Examined surface</source>
        <translation>Untersuchte Oberfläche</translation>
    </message>
    <message>
        <source>Time spent</source>
        <translation>Verweilzeit</translation>
    </message>
    <message>
        <source>Largest force</source>
        <translation>Größte Kraft</translation>
    </message>
    <message>
        <source>Stiffness felt</source>
        <translation>Gefühlte Steifigkeit</translation>
    </message>
    <message>
        <source>No map</source>
        <translation>Keine Karte</translation>
    </message>
    <message>
        <source>Time spent, s</source>
        <translation>Verweilzeit, s</translation>
    </message>
    <message>
        <source>Largest force, N</source>
        <translation>Größte Kraft, N</translation>
    </message>
    <message>
        <source>Stiffness felt, N/mm</source>
        <translation>Gefühlte Steifigkeit, N/mm</translation>
    </message>
    <message>
        <source>live, %1 s (preview)</source>
        <translation>live, %1 s (Vorschau)</translation>
    </message>
    <message>
        <source>up to %1 s</source>
        <translation>bis %1 s</translation>
    </message>
    <message>
        <source>nothing touched yet</source>
        <translation>noch nichts berührt</translation>
    </message>
    <message>
        <source>touched: %1</source>
        <translation>berührt: %1</translation>
    </message>
    <message>
        <source>above %1: %2</source>
        <translation>über %1: %2</translation>
    </message>
    <message>
        <source>touched</source>
        <translation>berührt</translation>
    </message>
    <message>
        <source>A up to %1 s, B up to %2 s</source>
        <translation>A bis %1 s, B bis %2 s</translation>
    </message>
    <message>
        <source>only A: %1</source>
        <translation>nur A: %1</translation>
    </message>
    <message>
        <source>both: %1</source>
        <translation>beide: %1</translation>
    </message>
    <message>
        <source>only B: %1</source>
        <translation>nur B: %1</translation>
    </message>
    <message>
        <source>%1, %2 %</source>
        <translation>%1, %2 %</translation>
    </message>
    <message>
        <source>only A</source>
        <translation>nur A</translation>
    </message>
    <message>
        <source>both</source>
        <translation>beide</translation>
    </message>
    <message>
        <source>only B</source>
        <translation>nur B</translation>
    </message>
</context>
<context>
    <name>palpate::ui::TouchPanel</name>
    <message>
        <source>%1 mm deep · %2 N/mm</source>
        <translation>%1 mm tief · %2 N/mm</translation>
    </message>
    <message>
        <source>N</source>
        <translation>N</translation>
    </message>
    <message>
        <source>Force on the hand [N]</source>
        <translation>Kraft auf die Hand [N]</translation>
    </message>
    <message>
        <source>Touched structure</source>
        <translation>Berührte Struktur</translation>
    </message>
    <message>
        <source>Depth and stiffness</source>
        <translation>Tiefe und Steifigkeit</translation>
    </message>
    <message>
        <source>press on a structure to feel it</source>
        <translation>auf eine Struktur drücken, um sie zu fühlen</translation>
    </message>
    <message>
        <source>%1 mm deep · slid aside</source>
        <translation>%1 mm tief · zur Seite gerutscht</translation>
    </message>
    <message>
        <source>slid aside</source>
        <translation>zur Seite gerutscht</translation>
    </message>
    <message>
        <source>%1 N, %2 mm deep</source>
        <translation>%1 N, %2 mm tief</translation>
    </message>
    <message>
        <source>Not touching</source>
        <translation>Keine Berührung</translation>
    </message>
    <message>
        <source>the hand is free</source>
        <translation>die Hand ist frei</translation>
    </message>
    <message>
        <source>%1 in %2</source>
        <translation>%1 in %2</translation>
    </message>
    <message>
        <source>over %1: %2, %3</source>
        <translation>über %1: %2, %3</translation>
    </message>
    <message>
        <source>over %1: %2</source>
        <translation>über %1: %2</translation>
    </message>
    <message>
        <source>Force in newtons</source>
        <translation>Kraft in Newton</translation>
    </message>
    <message>
        <source>Touched structures from outside in, with forces and depths</source>
        <translation>Berührte Strukturen von außen nach innen, mit Kräften und Tiefen</translation>
    </message>
    <message>
        <source>Touched layers from outside in: share of the total force [N], measured along
the total force, and depth of the hand in each layer [mm]</source>
        <translation>Berührte Schichten von außen nach innen: Anteil an der Gesamtkraft [N], längs der
Gesamtkraft gemessen, und Tiefe der Hand in jeder Schicht [mm]</translation>
    </message>
    <message>
        <source>Depth of the hand below the outermost surface [mm]; stiffness of all touched layers together [N/mm]</source>
        <translation>Tiefe der Hand unter der äußersten Oberfläche [mm]; Steifigkeit aller berührten Schichten zusammen [N/mm]</translation>
    </message>
    <message>
        <source>The mesh has more triangles here than can be evaluated in time</source>
        <translation>Das Netz hat hier mehr Dreiecke, als sich rechtzeitig auswerten lassen</translation>
    </message>
    <message>
        <source>very fine mesh here: force delayed</source>
        <translation>hier sehr feines Netz: Kraft verzögert</translation>
    </message>
    <message>
        <source>Source of the values: the live hand or the recording</source>
        <translation>Herkunft der Werte: die lebende Hand oder die Aufnahme</translation>
    </message>
    <message>
        <source>Recording, %1 s</source>
        <translation>Aufnahme, %1 s</translation>
    </message>
    <message>
        <source>Live hand</source>
        <translation>Lebende Hand</translation>
    </message>
</context>
<context>
    <name>palpate::ui::TouchSound</name>
    <message>
        <source>built without Qt Multimedia</source>
        <translation>ohne Qt Multimedia gebaut</translation>
    </message>
    <message>
        <source>no loudspeaker found</source>
        <translation>kein Lautsprecher gefunden</translation>
    </message>
    <message>
        <source>%1 cannot play the tone</source>
        <translation>%1 kann den Ton nicht abspielen</translation>
    </message>
</context>
<context>
    <name>palpate::ui::Tour</name>
    <message>
        <source>Back</source>
        <translation>Zurück</translation>
    </message>
    <message>
        <source>End (Esc)</source>
        <translation>Beenden (Esc)</translation>
    </message>
    <message>
        <source>%1 of %2: %3</source>
        <translation>%1 von %2: %3</translation>
    </message>
    <message>
        <source>Done</source>
        <translation>Fertig</translation>
    </message>
    <message>
        <source>Next</source>
        <translation>Weiter</translation>
    </message>
</context>
<context>
    <name>palpate::ui::ViewKeys</name>
    <message>
        <source>← → ↑ ↓</source>
        <translation>← → ↑ ↓</translation>
    </message>
    <message>
        <source>+  −</source>
        <translation>+  −</translation>
    </message>
    <message>
        <source>zoom</source>
        <translation>zoomen</translation>
    </message>
    <message>
        <source>Ctrl+← → ↑ ↓</source>
        <translation>Strg+← → ↑ ↓</translation>
    </message>
    <message>
        <source>Enter</source>
        <translation>Enter</translation>
    </message>
    <message>
        <source>Page down  up</source>
        <translation>Bild ab  auf</translation>
    </message>
    <message>
        <source>rotate the camera by 15°; with Shift: pan</source>
        <translation>die Kamera um 15° drehen; mit Umschalt: verschieben</translation>
    </message>
    <message>
        <source>move the press point by 2 mm on screen</source>
        <translation>die Druckstelle um 2 mm auf dem Bildschirm verschieben</translation>
    </message>
    <message>
        <source>press, release</source>
        <translation>drücken, loslassen</translation>
    </message>
    <message>
        <source>press 0.5 mm deeper, less deep</source>
        <translation>0,5 mm tiefer, weniger tief drücken</translation>
    </message>
</context>
<context>
    <name>palpate::ui::ViewVoice</name>
    <message>
        <source>3D view</source>
        <translation>3D-Ansicht</translation>
    </message>
    <message>
        <source>3D view: %1, %2</source>
        <translation>3D-Ansicht: %1, %2</translation>
    </message>
</context>
<context>
    <name>palpate::ui::WelcomePage</name>
    <message>
        <source>Try the phantom</source>
        <translation>Phantom ausprobieren</translation>
    </message>
    <message>
        <source>Recent</source>
        <translation>Zuletzt</translation>
    </message>
    <message>
        <source>Feel segmented anatomy</source>
        <translation>Segmentierte Anatomie tasten</translation>
    </message>
    <message>
        <source>Drop surface meshes or a scene here: %1</source>
        <translation>Oberflächennetze oder eine Szene hier ablegen: %1</translation>
    </message>
    <message>
        <source>Open anatomy…</source>
        <translation>Anatomie öffnen…</translation>
    </message>
    <message>
        <source>Open mesh or scene files (Ctrl+O)</source>
        <translation>Netz- oder Szenendateien öffnen (Strg+O)</translation>
    </message>
    <message>
        <source>or</source>
        <translation>oder</translation>
    </message>
    <message>
        <source>Open the bundled phantom: a liver with two lumps and a recorded palpation</source>
        <translation>Das mitgelieferte Phantom öffnen: eine Leber mit zwei Knoten und eine aufgezeichnete Palpation</translation>
    </message>
    <message>
        <source>Then click Palpate and drag on the anatomy to press; the wheel sets the depth. Press ? for all keys.</source>
        <translation>Dann auf Tasten klicken und auf der Anatomie ziehen, um zu drücken; das Rad stellt die Tiefe. ? zeigt alle Tasten.</translation>
    </message>
</context>
</TS>
