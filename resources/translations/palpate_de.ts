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
        <source>Coordinates: LPS</source>
        <translation>Koordinaten: LPS</translation>
    </message>
    <message>
        <source>The files count to the patient&apos;s left, back and head, as DICOM does</source>
        <translation>Die Dateien zählen nach links, hinten und kopfwärts des Patienten, wie DICOM</translation>
    </message>
    <message>
        <source>Coordinates: RAS</source>
        <translation>Koordinaten: RAS</translation>
    </message>
    <message>
        <source>The files count to the patient&apos;s right, front and head, as older models of 3D Slicer do</source>
        <translation>Die Dateien zählen nach rechts, vorn und kopfwärts des Patienten, wie ältere Modelle von 3D Slicer</translation>
    </message>
    <message>
        <source>Coordinates: Y up</source>
        <translation>Koordinaten: Y oben</translation>
    </message>
    <message>
        <source>The files count to the patient&apos;s left, head and front, as modelling programs do</source>
        <translation>Die Dateien zählen nach links, kopfwärts und nach vorn, wie Modellierprogramme</translation>
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
        <source>The files&apos; coordinates are %1.</source>
        <translation>Die Koordinaten der Dateien sind %1.</translation>
    </message>
    <message>
        <source>Not every file says along which axes it lies: %1 is assumed, and left and right may be exchanged. Click to say it.</source>
        <translation>Nicht jede Datei sagt, an welchen Achsen sie liegt: %1 ist angenommen, links und rechts können vertauscht sein. Zum Angeben klicken.</translation>
    </message>
    <message>
        <source>The surfaces are a recording&apos;s and stay as they were felt.</source>
        <translation>Die Oberflächen gehören zu einer Aufzeichnung und bleiben, wie sie getastet wurden.</translation>
    </message>
    <message>
        <source>Coordinates: %1</source>
        <translation>Koordinaten: %1</translation>
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
        <source>Nothing is touched: press on the place first, then mark it (M).</source>
        <translation>Nichts ist berührt: erst auf die Stelle drücken, dann markieren (M).</translation>
    </message>
    <message>
        <source>Finding %1</source>
        <translation>Befund %1</translation>
    </message>
    <message>
        <source>%1 marked on %2 with %3 N</source>
        <translation>%1 auf %2 markiert, mit %3 N</translation>
    </message>
    <message>
        <source>Note %1</source>
        <translation>Notiz %1</translation>
    </message>
    <message>
        <source>No finding yet: press on a place and mark it (M).</source>
        <translation>Noch kein Befund: auf eine Stelle drücken und sie markieren (M).</translation>
    </message>
    <message>
        <source>%1 keeps no view.</source>
        <translation>%1 hat keine Ansicht gespeichert.</translation>
    </message>
    <message>
        <source>%1 was not marked in a recording.</source>
        <translation>%1 wurde nicht in einer Aufzeichnung markiert.</translation>
    </message>
    <message>
        <source>A recording is being made: stop it (R) to play.</source>
        <translation>Eine Aufzeichnung läuft: zum Abspielen erst beenden (R).</translation>
    </message>
    <message>
        <source>%1: the recording of %2 is not there any more.</source>
        <translation>%1: die Aufzeichnung von %2 ist nicht mehr da.</translation>
    </message>
    <message>
        <source>%1: this is another recording than the one in which %2 was marked.</source>
        <translation>%1: dies ist eine andere Aufzeichnung als die, in der %2 markiert wurde.</translation>
    </message>
    <message numerus="yes">
        <source>%n finding(s) written to %1</source>
        <translation>
            <numerusform>%n Befund nach %1 geschrieben</numerusform>
            <numerusform>%n Befunde nach %1 geschrieben</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Import %n finding(s)</source>
        <translation>
            <numerusform>%n Befund importieren</numerusform>
            <numerusform>%n Befunde importieren</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n finding(s) taken from %1</source>
        <translation>
            <numerusform>%n Befund aus %1 übernommen</numerusform>
            <numerusform>%n Befunde aus %1 übernommen</numerusform>
        </translation>
    </message>
    <message>
        <source>, stiffness %1</source>
        <translation>, Steifigkeit %1</translation>
    </message>
</context>
<context>
    <name>LumpLayout</name>
    <message>
        <source>%1 lies in %2 and is felt below it, as a layer: %3</source>
        <translation>%1 liegt in %2 und wird darunter gefühlt, als Schicht: %3</translation>
    </message>
    <message>
        <source>its surface is open or inside out</source>
        <translation>die Oberfläche ist offen oder verkehrt herum</translation>
    </message>
    <message>
        <source>%1 is a lump itself</source>
        <translation>%1 ist selbst ein Knoten</translation>
    </message>
    <message>
        <source>a scene file could not name %1 alone</source>
        <translation>eine Szenendatei könnte %1 nicht allein benennen</translation>
    </message>
    <message>
        <source>it reaches out of %1</source>
        <translation>sie ragt aus %1 heraus</translation>
    </message>
    <message>
        <source>it is as stiff as %1</source>
        <translation>so steif wie %1</translation>
    </message>
    <message>
        <source>%1 seems to lie in %2, whose surface is open or inside out: it is felt neither through nor below it</source>
        <translation>%1 liegt anscheinend in %2, dessen Oberfläche offen oder verkehrt herum ist: weder durch das Organ noch darunter zu fühlen</translation>
    </message>
    <message>
        <source>%1 lies inside %2, %3 times as stiff (%4), and is felt through it</source>
        <translation>%1 liegt in %2, %3-mal so steif (%4), und wird hindurch getastet</translation>
    </message>
    <message>
        <source>a map varies how stiff it or %1 is</source>
        <translation>eine Karte ändert seine Steifigkeit oder die von %1</translation>
    </message>
    <message>
        <source>how many times as stiff as %1 is it? Type it in What can be felt (B)</source>
        <translation>wievielmal so steif wie %1 ist es? In „Was tastbar ist“ (B) eingeben</translation>
    </message>
</context>
<context>
    <name>MainWindow</name>
    <message>
        <source>Palpate</source>
        <translation>Tasten</translation>
    </message>
    <message>
        <source>Structures</source>
        <translation>Strukturen</translation>
    </message>
    <message>
        <source>Touch</source>
        <translation>Berührung</translation>
    </message>
    <message>
        <source>Device</source>
        <translation>Gerät</translation>
    </message>
    <message>
        <source>Session</source>
        <translation>Sitzung</translation>
    </message>
    <message>
        <source>Progress of opening</source>
        <translation>Fortschritt des Öffnens</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Research, training and planning rehearsal. Not a medical device.</source>
        <translation>Forschung, Ausbildung und Planungsübung. Kein Medizinprodukt.</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>Rückgängig</translation>
    </message>
    <message>
        <source>Undo: %1</source>
        <translation>Rückgängig: %1</translation>
    </message>
    <message>
        <source>Redo</source>
        <translation>Wiederholen</translation>
    </message>
    <message>
        <source>Redo: %1</source>
        <translation>Wiederholen: %1</translation>
    </message>
    <message>
        <source>Opening was cancelled.</source>
        <translation>Das Öffnen wurde abgebrochen.</translation>
    </message>
    <message>
        <source>Reading what varies over %1…</source>
        <translation>Lese, was über %1 variiert…</translation>
    </message>
    <message>
        <source>The map of %1 is felt.</source>
        <translation>Die Karte von %1 ist zu fühlen.</translation>
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
        <source>Snapshot</source>
        <translation>Foto</translation>
    </message>
    <message>
        <source>Save a picture of the view</source>
        <translation>Ein Bild der Ansicht speichern</translation>
    </message>
    <message>
        <source>Quit</source>
        <translation>Beenden</translation>
    </message>
    <message>
        <source>End Palpate</source>
        <translation>Palpate beenden</translation>
    </message>
    <message>
        <source>Undo the newest change</source>
        <translation>Die neueste Änderung zurücknehmen</translation>
    </message>
    <message>
        <source>Do it again</source>
        <translation>Wieder ausführen</translation>
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
        <source>Findings</source>
        <translation>Befunde</translation>
    </message>
    <message>
        <source>Show the places marked as findings</source>
        <translation>Die als Befund markierten Stellen zeigen</translation>
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
    <message>
        <source>hold Space</source>
        <translation>Leertaste halten</translation>
    </message>
    <message>
        <source>palpate while it is held</source>
        <translation>tasten, solange sie gehalten wird</translation>
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
        <source>let go, then back to the camera</source>
        <translation>loslassen, dann zurück zur Kamera</translation>
    </message>
    <message>
        <source>show or hide, feel or not</source>
        <translation>zeigen oder verbergen, fühlen oder nicht</translation>
    </message>
    <message>
        <source>Ctrl+↓  ↑</source>
        <translation>Strg+↓  ↑</translation>
    </message>
    <message>
        <source>felt a layer deeper, farther out</source>
        <translation>eine Schicht tiefer oder weiter außen gefühlt</translation>
    </message>
    <message>
        <source>Record</source>
        <translation>Aufnehmen</translation>
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
        <source>Back to the recording&apos;s start</source>
        <translation>Zurück zum Anfang der Aufzeichnung</translation>
    </message>
    <message>
        <source>Mark a finding</source>
        <translation>Befund markieren</translation>
    </message>
    <message>
        <source>Mark the place that is touched, in the scene and in the recording</source>
        <translation>Die berührte Stelle in Szene und Aufzeichnung markieren</translation>
    </message>
    <message>
        <source>Note…</source>
        <translation>Notiz…</translation>
    </message>
    <message>
        <source>Results…</source>
        <translation>Ergebnisse…</translation>
    </message>
    <message>
        <source>Forces, coverage and findings of the recording, and exports</source>
        <translation>Kräfte, Abdeckung und Befunde der Aufzeichnung, und Exporte</translation>
    </message>
    <message>
        <source>Keep the surfaces inside recordings</source>
        <translation>Oberflächen in Aufzeichnungen mitspeichern</translation>
    </message>
    <message>
        <source>One file then holds the whole session; it grows by what the meshes take</source>
        <translation>Eine Datei enthält dann die ganze Sitzung; sie wächst um die Größe der Netze</translation>
    </message>
    <message>
        <source>All keys</source>
        <translation>Alle Tasten</translation>
    </message>
    <message>
        <source>Show all keys</source>
        <translation>Alle Tasten zeigen</translation>
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
        <source>Recording</source>
        <translation>Aufzeichnung</translation>
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
        <source>&amp;Device</source>
        <translation>&amp;Gerät</translation>
    </message>
    <message>
        <source>P palpate, drag to press, wheel for depth</source>
        <translation>P tastet, Ziehen drückt, das Rad stellt die Tiefe</translation>
    </message>
    <message>
        <source>Feel again</source>
        <translation>Wieder fühlen</translation>
    </message>
    <message>
        <source>This anatomy is %1 mm across: its numbers are probably metres.</source>
        <translation>Diese Anatomie ist %1 mm groß: ihre Zahlen sind wohl Meter.</translation>
    </message>
    <message>
        <source>Read as metres</source>
        <translation>Als Meter lesen</translation>
    </message>
    <message>
        <source>1 note on these files</source>
        <translation>1 Hinweis zu diesen Dateien</translation>
    </message>
    <message>
        <source>%1 notes on these files</source>
        <translation>%1 Hinweise zu diesen Dateien</translation>
    </message>
    <message>
        <source>%1 can be played, but the meshes that it was made on are not where they were. Open them to see what was touched.</source>
        <translation>%1 lässt sich abspielen, doch die Netze, auf denen sie entstand, sind nicht, wo sie waren. Öffnen Sie sie, um zu sehen, was berührt wurde.</translation>
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
        <source>Unsaved scene</source>
        <translation>Ungespeicherte Szene</translation>
    </message>
    <message>
        <source>%1[*] – Palpate</source>
        <translation>%1[*] – Palpate</translation>
    </message>
    <message>
        <source>Palpate ended unexpectedly and left unsaved changes of a scene.</source>
        <translation>Palpate wurde unerwartet beendet und hinterließ nicht gespeicherte Änderungen einer Szene.</translation>
    </message>
    <message>
        <source>Restore</source>
        <translation>Zurückholen</translation>
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
        <source>%1; %2 more of that kind: Felt in the panel has each.</source>
        <translation>%1; %2 weitere dieser Art: „Gefühlt“ im Panel nennt jede.</translation>
    </message>
    <message>
        <source>Feel what is inside below what is around it</source>
        <translation>Was innen liegt, unter dem fühlen, was es umgibt</translation>
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
        <source>%1 lies in %2, but this scene has all in one layer: it is not felt through %2.</source>
        <translation>%1 liegt in %2, doch in dieser Szene liegt alles in einer Schicht: durch %2 hindurch ist es nicht zu fühlen.</translation>
    </message>
    <message>
        <source>Feel it below</source>
        <translation>Darunter fühlen</translation>
    </message>
    <message>
        <source>Recorded to %1</source>
        <translation>Nach %1 aufgezeichnet</translation>
    </message>
    <message>
        <source>Recording %1</source>
        <translation>Aufzeichnung %1</translation>
    </message>
    <message>
        <source>Picture saved to %1</source>
        <translation>Bild nach %1 gespeichert</translation>
    </message>
    <message>
        <source>%1: the picture could not be written. Is the folder writable and the disk not full?</source>
        <translation>%1: das Bild konnte nicht geschrieben werden. Ist der Ordner beschreibbar und der Datenträger nicht voll?</translation>
    </message>
    <message>
        <source>Palpate[*]</source>
        <translation>Palpate[*]</translation>
    </message>
    <message>
        <source>Findings and measures</source>
        <translation>Befunde und Maße</translation>
    </message>
    <message>
        <source>Open what was recorded</source>
        <translation>Aufgezeichnetes öffnen</translation>
    </message>
    <message>
        <source>Add to the scene…</source>
        <translation>Zur Szene hinzufügen…</translation>
    </message>
    <message>
        <source>Open more meshes or a scene beside what is open</source>
        <translation>Weitere Netze oder eine Szene zu dem öffnen, was offen ist</translation>
    </message>
    <message>
        <source>Close the scene</source>
        <translation>Szene schließen</translation>
    </message>
    <message>
        <source>Close what is open</source>
        <translation>Schließen, was offen ist</translation>
    </message>
    <message>
        <source>Import findings…</source>
        <translation>Befunde importieren…</translation>
    </message>
    <message>
        <source>Take the points of a 3D Slicer markups file (.mrk.json) as findings</source>
        <translation>Die Punkte einer Markups-Datei von 3D Slicer (.mrk.json) als Befunde übernehmen</translation>
    </message>
    <message>
        <source>Export findings…</source>
        <translation>Befunde exportieren…</translation>
    </message>
    <message>
        <source>Write findings and notes as a table (CSV) or as 3D Slicer markups (.mrk.json)</source>
        <translation>Befunde und Notizen als Tabelle (CSV) oder als Markups von 3D Slicer (.mrk.json) schreiben</translation>
    </message>
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
        <source>Write another name for the selected structure</source>
        <translation>Der gewählten Struktur einen anderen Namen geben</translation>
    </message>
    <message>
        <source>Remove from the scene</source>
        <translation>Aus der Szene entfernen</translation>
    </message>
    <message>
        <source>Take the selected structures out of the scene; their files stay</source>
        <translation>Die gewählten Strukturen aus der Szene nehmen; ihre Dateien bleiben</translation>
    </message>
    <message>
        <source>click</source>
        <translation>Klick</translation>
    </message>
    <message>
        <source>camera: select the structure (with Ctrl: one more)</source>
        <translation>Kamera: die Struktur wählen (mit Strg: eine weitere)</translation>
    </message>
    <message>
        <source>Ctrl+E  Ctrl+H</source>
        <translation>Strg+E  Strg+H</translation>
    </message>
    <message>
        <source>letters</source>
        <translation>Buchstaben</translation>
    </message>
    <message>
        <source>go to the structure that begins so</source>
        <translation>zur Struktur gehen, die so beginnt</translation>
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
        <source>in the findings: play where it was marked</source>
        <translation>in den Befunden: abspielen, wo markiert wurde</translation>
    </message>
    <message>
        <source>Mark a finding and write…</source>
        <translation>Befund markieren und schreiben…</translation>
    </message>
    <message>
        <source>Mark the place that is touched and write about it</source>
        <translation>Die berührte Stelle markieren und etwas dazu schreiben</translation>
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
        <source>Go to the next finding, in the view from which it was marked</source>
        <translation>Zum nächsten Befund, in der Ansicht, aus der er markiert wurde</translation>
    </message>
    <message>
        <source>Previous finding</source>
        <translation>Voriger Befund</translation>
    </message>
    <message>
        <source>Go to the finding before</source>
        <translation>Zum Befund davor</translation>
    </message>
    <message>
        <source>What the pointer or the device does</source>
        <translation>Was Zeiger oder Gerät tut</translation>
    </message>
    <message>
        <source>Stop the recording first: it holds the surfaces as they lie now.</source>
        <translation>Beenden Sie erst die Aufzeichnung: sie hält die Oberflächen, wie sie jetzt liegen.</translation>
    </message>
    <message>
        <source>%1  ·  %2 (F4 lists them)</source>
        <translation>%1  ·  %2 (F4 zeigt sie)</translation>
    </message>
    <message>
        <source>Read again with coordinates %1: tissue and findings are kept, undo starts anew.</source>
        <translation>Neu gelesen mit Koordinaten %1: Gewebe und Befunde bleiben, Rückgängig beginnt neu.</translation>
    </message>
    <message>
        <source>The scene was changed elsewhere</source>
        <translation>Die Szene wurde anderswo geändert</translation>
    </message>
    <message>
        <source>%1 was saved by another window or program since it was opened here. To save it would replace what was saved there.</source>
        <translation>%1 wurde von einem anderen Fenster oder Programm gespeichert, seit sie hier geöffnet wurde. Speichern würde das dort Gespeicherte ersetzen.</translation>
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
        <source>%1 and %2 more</source>
        <translation>%1 und %2 weitere</translation>
    </message>
    <message>
        <source>These changes were already restored in another window.</source>
        <translation>Diese Änderungen wurden schon in einem anderen Fenster wiederhergestellt.</translation>
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
        <source>Add to the scene</source>
        <translation>Zur Szene hinzufügen</translation>
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
        <source>%1 was added to the scene.</source>
        <translation>%1 wurde zur Szene hinzugefügt.</translation>
    </message>
    <message>
        <source>%1 structures were added to the scene.</source>
        <translation>%1 Strukturen wurden zur Szene hinzugefügt.</translation>
    </message>
    <message>
        <source>What was added lies in or around other structures, but the layers that were set are kept.</source>
        <translation>Das Hinzugefügte liegt in oder um andere Strukturen, doch die eingestellten Schichten bleiben.</translation>
    </message>
    <message>
        <source>Tissue by names</source>
        <translation>Gewebe nach Namen</translation>
    </message>
    <message>
        <source>%1 got its tissue by its name.</source>
        <translation>%1 bekam sein Gewebe nach dem Namen.</translation>
    </message>
    <message>
        <source>%1 structures got tissue by their names.</source>
        <translation>%1 Strukturen bekamen ihr Gewebe nach den Namen.</translation>
    </message>
    <message>
        <source>Tissue as before</source>
        <translation>Gewebe wie zuvor</translation>
    </message>
    <message>
        <source>Next panel</source>
        <translation>Nächstes Panel</translation>
    </message>
    <message>
        <source>The keys go to the next panel, and on to the view</source>
        <translation>Die Tasten gehen zum nächsten Panel und weiter zur Ansicht</translation>
    </message>
    <message>
        <source>Previous panel</source>
        <translation>Voriges Panel</translation>
    </message>
    <message>
        <source>The keys go to the panel before</source>
        <translation>Die Tasten gehen zum Panel davor</translation>
    </message>
    <message>
        <source>Hide or show all panels</source>
        <translation>Alle Panels verbergen oder zeigen</translation>
    </message>
    <message>
        <source>Messages</source>
        <translation>Meldungen</translation>
    </message>
    <message>
        <source>Show or hide the list of all messages since the start, with all notes on files</source>
        <translation>Die Liste aller Meldungen seit dem Start, mit allen Hinweisen zu Dateien, zeigen oder verbergen</translation>
    </message>
    <message>
        <source>Single-letter keys</source>
        <translation>Tasten mit Buchstaben</translation>
    </message>
    <message>
        <source>Commands by one letter; off: letters do nothing, for speech input and for hands that touch keys by chance</source>
        <translation>Befehle mit einem Buchstaben; aus: Buchstaben tun nichts, für Spracheingabe und für Hände, die Tasten versehentlich berühren</translation>
    </message>
    <message>
        <source>Touching with the %1</source>
        <translation>Tasten mit: %1</translation>
    </message>
    <message>
        <source>Turning the view</source>
        <translation>Die Ansicht drehen</translation>
    </message>
    <message>
        <source>The phantom was not found beside the program.</source>
        <translation>Das Phantom wurde neben dem Programm nicht gefunden.</translation>
    </message>
    <message>
        <source>As recorded, the fingertip is a ball of %1 mm radius (Session › Fingertip).</source>
        <translation>Wie aufgezeichnet ist die Fingerspitze eine Kugel mit %1 mm Radius (Sitzung › Fingerspitze).</translation>
    </message>
    <message>
        <source>As recorded, the fingertip is a point (Session › Fingertip).</source>
        <translation>Wie aufgezeichnet ist die Fingerspitze ein Punkt (Sitzung › Fingerspitze).</translation>
    </message>
    <message>
        <source>Lift the hand</source>
        <translation>Hand anheben</translation>
    </message>
    <message>
        <source>Move the device without the hand in the scene, as a mouse is lifted; again to go on</source>
        <translation>Das Gerät ohne die Hand in der Szene bewegen, wie man eine Maus anhebt; noch einmal: weiter</translation>
    </message>
    <message>
        <source>Record what the hand feels, at every moment</source>
        <translation>Aufzeichnen, was die Hand fühlt, in jedem Augenblick</translation>
    </message>
    <message>
        <source>Zoom the hand&apos;s space to everything</source>
        <translation>Raum der Hand auf alles zoomen</translation>
    </message>
    <message>
        <source>The device&apos;s whole way goes through all that is shown</source>
        <translation>Der ganze Weg des Geräts führt durch alles Gezeigte</translation>
    </message>
    <message>
        <source>Zoom the hand&apos;s space to the organ</source>
        <translation>Raum der Hand auf das Organ zoomen</translation>
    </message>
    <message>
        <source>The device&apos;s whole way goes through the organ that is touched or pointed at</source>
        <translation>Der ganze Weg des Geräts führt durch das Organ, das berührt wird oder unter dem Zeiger liegt</translation>
    </message>
    <message>
        <source>Zoom the hand&apos;s space to the lump</source>
        <translation>Raum der Hand auf den Knoten zoomen</translation>
    </message>
    <message>
        <source>The device&apos;s whole way is 10 mm, about what is touched, pointed at or found</source>
        <translation>Der ganze Weg des Geräts ist 10 mm, um das Berührte, das unter dem Zeiger oder den Befund</translation>
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
        <source>How touch runs</source>
        <translation>Wie das Tasten läuft</translation>
    </message>
    <message>
        <source>Touch with the device; O or L zooms its space to the organ or lump, C lifts the hand</source>
        <translation>Mit dem Gerät tasten; O oder L zoomt seinen Raum auf Organ oder Knoten, C hebt die Hand an</translation>
    </message>
    <message>
        <source>Engineering</source>
        <translation>Technik</translation>
    </message>
    <message>
        <source>Show or hide solver, servo loop and device in numbers</source>
        <translation>Löser, Servoschleife und Gerät in Zahlen zeigen oder verbergen</translation>
    </message>
    <message>
        <source>%1: %2 (%3)</source>
        <translation>%1: %2 (%3)</translation>
    </message>
    <message>
        <source>Forces may stutter: %1: %2. %3</source>
        <translation>Kräfte können stocken: %1: %2. %3</translation>
    </message>
    <message>
        <source>What can be felt here</source>
        <translation>Was hier tastbar ist</translation>
    </message>
    <message>
        <source>Colour organs by how much of the lumps below a hand feels, with a table</source>
        <translation>Organe danach färben, was eine Hand von den Knoten darunter spürt, mit einer Tabelle</translation>
    </message>
    <message>
        <source>What can be felt</source>
        <translation>Was tastbar ist</translation>
    </message>
    <message>
        <source>camera: zoom · palpate: depth in mm, or effort in N (with Ctrl: zoom)</source>
        <translation>Kamera: zoomen · Tasten: Tiefe in mm oder Kraft in N (mit Strg: zoomen)</translation>
    </message>
    <message>
        <source>Press by effort</source>
        <translation>Mit Kraft drücken</translation>
    </message>
    <message>
        <source>Effort in, depth out: the force rises while the button is held, or is a pen&apos;s pressure, and a stiff place gives way less; off: the wheel says how deep</source>
        <translation>Kraft hinein, Tiefe heraus: die Kraft wächst, solange die Taste gehalten wird, oder ist der Druck eines Stifts, und eine steife Stelle gibt weniger nach; aus: das Rad sagt, wie tief</translation>
    </message>
    <message>
        <source>What the pointer does: it turns the view, or it presses this far along the line of sight [mm] or with this force [N]; the wheel sets it (P switches)</source>
        <translation>Was der Zeiger tut: er dreht die Ansicht, oder er drückt so weit entlang der Blickrichtung [mm] oder mit dieser Kraft [N]; das Rad stellt es ein (P schaltet um)</translation>
    </message>
    <message>
        <source>Stop reading; what was open stays</source>
        <translation>Lesen abbrechen; was offen war, bleibt</translation>
    </message>
    <message>
        <source>Palpate with the pointer: drag to press, wheel for depth or effort; off: the pointer moves the camera</source>
        <translation>Mit dem Zeiger tasten: ziehen zum Drücken, Rad für Tiefe oder Kraft; aus: der Zeiger bewegt die Ansicht</translation>
    </message>
    <message>
        <source>P palpate, hold to press harder, wheel for the hardest press</source>
        <translation>P tastet, Halten drückt stärker, das Rad stellt den stärksten Druck</translation>
    </message>
    <message>
        <source>Dent under the finger</source>
        <translation>Delle unter dem Finger</translation>
    </message>
    <message>
        <source>Draw soft tissue bent where it is pressed, with a fine grid on it</source>
        <translation>Weiches Gewebe dort eingedrückt zeichnen, wo gedrückt wird, mit feinem Gitter darauf</translation>
    </message>
    <message>
        <source>The pointer says where, the SpaceMouse how hard: push its puck down. P palpate, wheel for the hardest press</source>
        <translation>Der Zeiger sagt, wo, die SpaceMouse, wie fest: ihren Puck nach unten drücken. P tastet, das Rad stellt den festesten Druck</translation>
    </message>
    <message>
        <source>Feel it as a layer</source>
        <translation>Als Schicht fühlen</translation>
    </message>
    <message numerus="yes">
        <source>%n did not: felt as “Firm organ”, 0.5 N/mm.</source>
        <translation>
            <numerusform>%n nicht: gefühlt als „Festes Organ“, 0,5 N/mm.</numerusform>
            <numerusform>%n nicht: gefühlt als „Festes Organ“, 0,5 N/mm.</numerusform>
        </translation>
    </message>
    <message>
        <source>Making the surface of %1…</source>
        <translation>Oberfläche von %1 wird erstellt…</translation>
    </message>
    <message>
        <source>%1 × %2 × %3 mm</source>
        <translation>%1 × %2 × %3 mm</translation>
    </message>
    <message>
        <source>%1 is a staircase of about %2 voxels: the hand feels its steps.</source>
        <translation>%1 ist eine Treppe aus Voxeln von etwa %2: Die Hand spürt ihre Stufen.</translation>
    </message>
    <message>
        <source>%1 surfaces are staircases, of about %2 voxels: the hand feels their steps.</source>
        <translation>%1 Oberflächen sind Treppen aus Voxeln von etwa %2: Die Hand spürt ihre Stufen.</translation>
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
        <source>%1 is inside out: felt from within only.</source>
        <translation>%1 ist umgestülpt: nur von innen spürbar.</translation>
    </message>
    <message>
        <source>%1 surfaces are inside out: felt from within only.</source>
        <translation>%1 Oberflächen sind umgestülpt: nur von innen spürbar.</translation>
    </message>
    <message>
        <source>Turn it around</source>
        <translation>Umdrehen</translation>
    </message>
    <message>
        <source>Turn them around</source>
        <translation>Alle umdrehen</translation>
    </message>
    <message>
        <source>%1 has another surface now.</source>
        <translation>%1 hat jetzt eine andere Oberfläche.</translation>
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
        <source>What became of the newest export</source>
        <translation>Was aus dem neuesten Export wurde</translation>
    </message>
    <message>
        <source>Progress of the export</source>
        <translation>Fortschritt des Exports</translation>
    </message>
    <message>
        <source>Cancel the export</source>
        <translation>Den Export abbrechen</translation>
    </message>
    <message>
        <source>Copy</source>
        <translation>Kopieren</translation>
    </message>
    <message>
        <source>Copy all tables, to be pasted into a spreadsheet (Ctrl+C)</source>
        <translation>Alle Tabellen kopieren, zum Einfügen in eine Tabellenkalkulation (Strg+C)</translation>
    </message>
    <message>
        <source>The path of the hand, and beside it the touched surface with time spent and peak force</source>
        <translation>Der Weg der Hand, daneben die berührte Oberfläche mit Verweildauer und Spitzenkraft</translation>
    </message>
    <message>
        <source>The tables above, and more, for a program</source>
        <translation>Die Tabellen oben, und mehr, für ein Programm</translation>
    </message>
    <message>
        <source>Copied: paste it into a spreadsheet.</source>
        <translation>Kopiert: in eine Tabellenkalkulation einfügen.</translation>
    </message>
    <message>
        <source>Nothing was written: %1 is there already. Choose it by its whole name to replace it.</source>
        <translation>Nichts wurde geschrieben: %1 gibt es schon. Wählen Sie die Datei mit vollem Namen, um sie zu ersetzen.</translation>
    </message>
    <message>
        <source>Nothing was written: %1 ends in %2. A name for %3 ends in %4.</source>
        <translation>Nichts wurde geschrieben: %1 endet auf %2. Ein Name für %3 endet auf %4.</translation>
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
        <source>The path is written to %1; the map is not: %2</source>
        <translation>Der Weg ist nach %1 geschrieben; die Karte nicht: %2</translation>
    </message>
    <message>
        <source>Every moment with its time, places, forces, depth and events</source>
        <translation>Jeder Augenblick mit Zeit, Orten, Kräften, Tiefe und Ereignissen</translation>
    </message>
</context>
<context>
    <name>RecordingControl</name>
    <message>
        <source>Recording</source>
        <translation>Aufzeichnung</translation>
    </message>
    <message>
        <source>A recording is running. End it and close?</source>
        <translation>Eine Aufzeichnung läuft. Beenden und schließen?</translation>
    </message>
    <message>
        <source>What was felt until now is kept in %1.</source>
        <translation>Was bis jetzt gefühlt wurde, bleibt in %1.</translation>
    </message>
    <message>
        <source>End the recording</source>
        <translation>Aufzeichnung beenden</translation>
    </message>
    <message>
        <source>Go on recording</source>
        <translation>Weiter aufzeichnen</translation>
    </message>
    <message>
        <source>● recording %1, the disk does not answer</source>
        <translation>● zeichnet %1 auf, der Datenträger antwortet nicht</translation>
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
        <source>%1 ended by itself</source>
        <translation>%1 endete von selbst</translation>
    </message>
    <message>
        <source>Length of the recording [min:s]; moments of 1 ms that were late, because the computer was busy: nothing was felt in them; moments that were lost, because the disk was slow: they were felt and are not in it</source>
        <translation>Länge der Aufzeichnung [min:s]; Augenblicke von 1 ms, die verspätet waren, weil der Rechner beschäftigt war: in ihnen wurde nichts gefühlt; Augenblicke, die verloren gingen, weil der Datenträger langsam war: sie wurden gefühlt und fehlen darin</translation>
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
        <source>not said</source>
        <translation>keine Angabe</translation>
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
        <source>Nearly highest [N]</source>
        <translation>Fast höchste [N]</translation>
    </message>
    <message>
        <source>Peak [N]</source>
        <translation>Spitze [N]</translation>
    </message>
    <message>
        <source>Deepest [mm]</source>
        <translation>Tiefste [mm]</translation>
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
        <source>Search and press</source>
        <translation>Suchen und Drücken</translation>
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
        <source>Share of the surface that was examined: within %1, the fingertip&apos;s radius</source>
        <translation>Anteil der untersuchten Oberfläche: innerhalb von %1, dem Radius der Fingerspitze</translation>
    </message>
    <message>
        <source>Share of the surface that was examined: within %1</source>
        <translation>Anteil der untersuchten Oberfläche: innerhalb von %1</translation>
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
        <source>Longest time at one place [s]</source>
        <translation>Längste Zeit an einer Stelle [s]</translation>
    </message>
    <message>
        <source>its mesh is not there</source>
        <translation>ihr Netz ist nicht da</translation>
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
        <source>Times returned</source>
        <translation>Wiederkehr</translation>
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
        <source>Findings, layer by layer</source>
        <translation>Befunde, Schicht für Schicht</translation>
    </message>
    <message>
        <source>Felt when marked</source>
        <translation>Beim Markieren gefühlt</translation>
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
        <source>Nearly highest: the force that 95 % of the contact stayed below. Research measures, not a diagnosis.</source>
        <translation>Fast höchste: die Kraft, unter der 95 % des Kontakts blieben. Maße für die Forschung, keine Diagnose.</translation>
    </message>
    <message>
        <source>Moments late</source>
        <translation>Verspätete Augenblicke</translation>
    </message>
    <message>
        <source>Moments lost</source>
        <translation>Verlorene Augenblicke</translation>
    </message>
    <message>
        <source>Lump</source>
        <translation>Knoten</translation>
    </message>
    <message>
        <source>In</source>
        <translation>In</translation>
    </message>
    <message>
        <source>Felt by a trained hand from [cm²]</source>
        <translation>Für geübte Hand fühlbar von [cm²]</translation>
    </message>
    <message>
        <source>Of that pressed hard enough [%]</source>
        <translation>Davon fest genug gedrückt [%]</translation>
    </message>
    <message>
        <source>not by hand</source>
        <translation>nicht mit der Hand</translation>
    </message>
    <message>
        <source>Lumps: what was recorded, and what the model predicts (an estimate)</source>
        <translation>Knoten: aufgezeichnet und vom Modell vorhergesagt (Schätzung)</translation>
    </message>
    <message>
        <source>Greatest change recorded [%]</source>
        <translation>Größte aufgezeichnete Änderung [%]</translation>
    </message>
    <message>
        <source>Predicted by the model [%]</source>
        <translation>Vom Modell vorhergesagt [%]</translation>
    </message>
</context>
<context>
    <name>SceneDocument</name>
    <message>
        <source>Mark %1</source>
        <translation>%1 markieren</translation>
    </message>
    <message>
        <source>Unsaved changes would be lost in a crash; save the scene. %1</source>
        <translation>Ungesicherte Änderungen gingen bei einem Absturz verloren; sichern Sie die Szene. %1</translation>
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
        <source>found no device plugin called &quot;%1&quot;, expected one of: %2 (&quot;palpate devices&quot; also lists the built-in devices)</source>
        <translation>kein Geräte-Plugin namens „%1“ gefunden, erwartet eines von: %2 („palpate devices“ nennt auch die eingebauten Geräte)</translation>
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
</context>
<context>
    <name>palpate::app::Fingertip</name>
    <message>
        <source>Fingertip</source>
        <translation>Fingerspitze</translation>
    </message>
    <message>
        <source>Ball of %1 mm radius</source>
        <translation>Kugel mit %1 mm Radius</translation>
    </message>
    <message>
        <source>Point</source>
        <translation>Punkt</translation>
    </message>
    <message>
        <source>What touches: a point feels every facet, a ball slides over small pits as a finger does</source>
        <translation>Was tastet: ein Punkt fühlt jede Facette, eine Kugel gleitet wie ein Finger über kleine Gruben</translation>
    </message>
</context>
<context>
    <name>palpate::app::Help</name>
    <message>
        <source>Documents</source>
        <translation>Dokumente</translation>
    </message>
    <message>
        <source>Open the folder of documents: keys, recordings, measures, glossary, devices</source>
        <translation>Den Ordner mit den Dokumenten öffnen: Tasten, Aufzeichnungen, Maße, Glossar, Geräte</translation>
    </message>
    <message>
        <source>About Palpate</source>
        <translation>Über Palpate</translation>
    </message>
    <message>
        <source>Version, build and licences, to copy for a report</source>
        <translation>Version, Build und Lizenzen, zum Kopieren für einen Bericht</translation>
    </message>
    <message>
        <source>The documents were not found beside the program.</source>
        <translation>Die Dokumente wurden neben dem Programm nicht gefunden.</translation>
    </message>
    <message>
        <source>Nothing here opens folders; the documents are in %1</source>
        <translation>Hier öffnet nichts Ordner; die Dokumente liegen in %1</translation>
    </message>
    <message>
        <source>Research, training and planning rehearsal. Not a medical device.

Palpate is free software under the BSD 3-Clause licence. It is made with Qt (LGPL 3), VTK (BSD 3-Clause), Eigen (MPL 2.0), SQLite (public domain), hidapi (BSD) and CLI11 (BSD 3-Clause).</source>
        <translation>Für Forschung, Ausbildung und Planungsübung. Kein Medizinprodukt.

Palpate ist freie Software unter der BSD-3-Clause-Lizenz. Verwendet werden Qt (LGPL 3), VTK (BSD 3-Clause), Eigen (MPL 2.0), SQLite (gemeinfrei), hidapi (BSD) und CLI11 (BSD 3-Clause).</translation>
    </message>
    <message>
        <source>Copy for a report</source>
        <translation>Für einen Bericht kopieren</translation>
    </message>
    <message>
        <source>Copied: version, build and system.</source>
        <translation>Kopiert: Version, Build und System.</translation>
    </message>
</context>
<context>
    <name>palpate::app::Language</name>
    <message>
        <source>Language</source>
        <translation>Sprache</translation>
    </message>
    <message>
        <source>Palpate speaks another language when it is started again.</source>
        <translation>Palpate spricht nach einem Neustart eine andere Sprache.</translation>
    </message>
    <message>
        <source>As the system</source>
        <translation>Wie das System</translation>
    </message>
</context>
<context>
    <name>palpate::app::ShowAround</name>
    <message>
        <source>Show me around</source>
        <translation>Kurzer Rundgang</translation>
    </message>
    <message>
        <source>Four notes on the window, on the practice liver when nothing is open</source>
        <translation>Vier Hinweise zum Fenster, an der Übungsleber, wenn nichts geöffnet ist</translation>
    </message>
    <message>
        <source>This is a practice liver with lumps inside.</source>
        <translation>Dies ist eine Übungsleber mit Knoten darin.</translation>
    </message>
    <message>
        <source>Shown on what is open; nothing of it is changed.</source>
        <translation>Gezeigt an dem, was geöffnet ist; nichts davon wird geändert.</translation>
    </message>
    <message>
        <source>Structures</source>
        <translation>Strukturen</translation>
    </message>
    <message>
        <source>The list has every structure. The eye shows or hides it, the hand lets you feel it or not; below stands the tissue that it is felt as.</source>
        <translation>Die Liste enthält alle Strukturen. Das Auge zeigt oder verbirgt eine, die Hand macht sie tastbar oder nicht; darunter steht, als welches Gewebe sie sich anfühlt.</translation>
    </message>
    <message>
        <source>Press to feel</source>
        <translation>Drücken und tasten</translation>
    </message>
    <message>
        <source>Press P, then drag on the anatomy: you press and slide, the wheel goes deeper. By keys: Ctrl and the arrows move the place, Enter presses, Page down goes deeper. Esc lets go.</source>
        <translation>P drücken, dann auf der Anatomie ziehen: so wird gedrückt und geglitten, das Rad geht tiefer. Mit Tasten: Strg und die Pfeile verschieben die Stelle, Eingabe drückt, Bild ab geht tiefer. Esc lässt los.</translation>
    </message>
    <message>
        <source>Touch</source>
        <translation>Berührung</translation>
    </message>
    <message>
        <source>The force in newtons, which structure is touched, how deep in millimetres, and the last ten seconds. What is stiffer than its surroundings pushes back more at the same depth.</source>
        <translation>Die Kraft in Newton, welche Struktur berührt wird, wie tief in Millimetern, und die letzten zehn Sekunden. Was fester ist als seine Umgebung, drückt bei gleicher Tiefe stärker zurück.</translation>
    </message>
    <message>
        <source>Record and findings</source>
        <translation>Aufzeichnung und Befunde</translation>
    </message>
    <message>
        <source>R records what you feel, and again ends it. M marks the place you touch as a finding: it stands here with force and depth; F2 names it. File › Export findings… writes them out.</source>
        <translation>R zeichnet auf, was gefühlt wird, und beendet es wieder. M merkt die berührte Stelle als Befund an: er steht hier mit Kraft und Tiefe; F2 benennt ihn. Datei › Befunde exportieren… schreibt sie heraus.</translation>
    </message>
</context>
<context>
    <name>palpate::app::SoundChoice</name>
    <message>
        <source>Sound of touch</source>
        <translation>Ton der Berührung</translation>
    </message>
    <message>
        <source>Hear a tone as high as the place is stiff, as loud as the force</source>
        <translation>Ein Ton so hoch, wie die Stelle steif ist, und so laut wie die Kraft</translation>
    </message>
    <message>
        <source>The sound of touch has ended: the loudspeaker is gone.</source>
        <translation>Der Ton der Berührung ist zu Ende: Der Lautsprecher ist fort.</translation>
    </message>
    <message>
        <source>Sound of touch (%1)</source>
        <translation>Ton der Berührung (%1)</translation>
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
        <source>What else there is to say</source>
        <translation>Was es sonst zu sagen gibt</translation>
    </message>
    <message>
        <source>What there is no room for in this row</source>
        <translation>Wofür in dieser Zeile kein Platz ist</translation>
    </message>
</context>
<context>
    <name>palpate::ui::DeviceChoice</name>
    <message>
        <source>Mouse</source>
        <translation>Maus</translation>
    </message>
    <message>
        <source>The pointer over the view; it feels nothing, the force is shown</source>
        <translation>Der Zeiger über der Ansicht; er fühlt nichts, die Kraft wird angezeigt</translation>
    </message>
    <message>
        <source>Simulated hand</source>
        <translation>Simulierte Hand</translation>
    </message>
    <message>
        <source>Palpates what is in the middle of the view, and feels the force</source>
        <translation>Tastet, was in der Mitte der Ansicht liegt, und fühlt die Kraft</translation>
    </message>
    <message>
        <source>The open recording&apos;s motion, felt with the tissue as it is now</source>
        <translation>Die Bewegung der offenen Aufzeichnung, gefühlt mit dem Gewebe, wie es jetzt ist</translation>
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
        <source>The puck turns and shifts the anatomy while another device is the hand</source>
        <translation>Der Puck dreht und verschiebt die Anatomie, während ein anderes Gerät die Hand ist</translation>
    </message>
    <message>
        <source>Calibrate</source>
        <translation>Kalibrieren</translation>
    </message>
    <message>
        <source>Takes the pose that the device is in now as its calibration pose</source>
        <translation>Nimmt die jetzige Stellung des Geräts als seine Kalibrierstellung</translation>
    </message>
    <message>
        <source>What is plugged in…</source>
        <translation>Was eingesteckt ist…</translation>
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
        <source>The hand&apos;s device: %1</source>
        <translation>Das Gerät der Hand: %1</translation>
    </message>
    <message>
        <source>It feels nothing: the force is shown, up to %1 N.</source>
        <translation>Es fühlt nichts: die Kraft wird angezeigt, bis %1 N.</translation>
    </message>
    <message>
        <source>Up to %1 N and %2 N/mm</source>
        <translation>Bis %1 N und %2 N/mm</translation>
    </message>
    <message>
        <source>%1: it would need %2.</source>
        <translation>%1: es bräuchte %2.</translation>
    </message>
    <message>
        <source>No haptic device and no 6-axis mouse is plugged in.</source>
        <translation>Kein haptisches Gerät und keine 6-Achsen-Maus ist eingesteckt.</translation>
    </message>
    <message>
        <source>Devices</source>
        <translation>Geräte</translation>
    </message>
    <message>
        <source>Replay with today&apos;s tissue</source>
        <translation>Wiedergabe mit dem heutigen Gewebe</translation>
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
        <source>recording, felt anew</source>
        <translation>Aufzeichnung, neu gefühlt</translation>
    </message>
    <message>
        <source>SpaceMouse presses</source>
        <translation>SpaceMouse drückt</translation>
    </message>
    <message>
        <source>The pointer says where, the puck how hard: the further it is pushed down, the more newtons of effort</source>
        <translation>Der Zeiger sagt, wo, der Puck, wie fest: Je weiter er nach unten gedrückt wird, desto mehr Newton</translation>
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
    <name>palpate::ui::Engine</name>
    <message>
        <source>the file is empty</source>
        <translation>die Datei ist leer</translation>
    </message>
    <message>
        <source>a web page (HTML), perhaps a failed download</source>
        <translation>eine Webseite (HTML), vielleicht ein misslungener Download</translation>
    </message>
    <message>
        <source>the content is no known mesh format</source>
        <translation>der Inhalt ist kein bekanntes Format einer Oberfläche</translation>
    </message>
    <message>
        <source>is %1, which Palpate does not read</source>
        <translation>ist %1; das liest Palpate nicht</translation>
    </message>
    <message>
        <source>a glTF file</source>
        <translation>eine glTF-Datei</translation>
    </message>
    <message>
        <source>a ZIP archive</source>
        <translation>ein ZIP-Archiv</translation>
    </message>
    <message>
        <source>a gzip file</source>
        <translation>eine gzip-Datei</translation>
    </message>
    <message>
        <source>an NRRD image</source>
        <translation>ein NRRD-Bild</translation>
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
        <source>a DICOM file</source>
        <translation>eine DICOM-Datei</translation>
    </message>
    <message>
        <source>an %1 mesh</source>
        <translation>eine Oberfläche (%1)</translation>
    </message>
    <message>
        <source>an %1 mesh: save it as one of these</source>
        <translation>eine Oberfläche (%1): in einem dieser Formate speichern</translation>
    </message>
    <message>
        <source>%1 or %2</source>
        <translation>%1 oder %2</translation>
    </message>
    <message>
        <source>a readable file</source>
        <translation>eine lesbare Datei</translation>
    </message>
    <message>
        <source>a mesh file</source>
        <translation>eine Datei mit einer Oberfläche</translation>
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
        <source>cannot be opened</source>
        <translation>kann nicht geöffnet werden</translation>
    </message>
    <message>
        <source>cannot be read</source>
        <translation>kann nicht gelesen werden</translation>
    </message>
    <message>
        <source>cannot be written</source>
        <translation>kann nicht geschrieben werden</translation>
    </message>
    <message>
        <source>cannot be written: %1; choose another folder</source>
        <translation>kann nicht geschrieben werden: %1; bitte einen anderen Ordner wählen</translation>
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
        <source>Is a directory</source>
        <translation>ist ein Ordner</translation>
    </message>
    <message>
        <source>the disk is full</source>
        <translation>der Datenträger ist voll</translation>
    </message>
    <message>
        <source>no memory to read it</source>
        <translation>kein Speicher, um sie zu lesen</translation>
    </message>
    <message>
        <source>not enough memory to read it</source>
        <translation>nicht genug Speicher, um sie zu lesen</translation>
    </message>
    <message>
        <source>a mesh that fits</source>
        <translation>eine Oberfläche, die hineinpasst</translation>
    </message>
    <message>
        <source>the file became shorter while it was read</source>
        <translation>die Datei wurde kürzer, während sie gelesen wurde</translation>
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
        <source>the folder cannot be read: %1</source>
        <translation>der Ordner kann nicht gelesen werden: %1</translation>
    </message>
    <message>
        <source>a folder of meshes</source>
        <translation>ein Ordner mit Oberflächen</translation>
    </message>
    <message>
        <source>no such file</source>
        <translation>die Datei ist nicht da</translation>
    </message>
    <message>
        <source>none of %1 triangle has an area</source>
        <translation>das Dreieck (%1) hat keine Fläche</translation>
    </message>
    <message>
        <source>none of %1 triangles has an area</source>
        <translation>keines von %1 Dreiecken hat eine Fläche</translation>
    </message>
    <message>
        <source>at least one that has</source>
        <translation>mindestens eines mit Fläche</translation>
    </message>
    <message>
        <source>at least one</source>
        <translation>mindestens eines</translation>
    </message>
    <message>
        <source>0 triangles</source>
        <translation>keine Dreiecke</translation>
    </message>
    <message>
        <source>0 faces</source>
        <translation>keine Flächen</translation>
    </message>
    <message>
        <source>0 polygons and strips</source>
        <translation>keine Vielecke und Streifen</translation>
    </message>
    <message>
        <source>%1 triangle</source>
        <translation>%1 Dreieck</translation>
    </message>
    <message>
        <source>%1 triangles</source>
        <translation>%1 Dreiecke</translation>
    </message>
    <message>
        <source>%1 point</source>
        <translation>%1 Punkt</translation>
    </message>
    <message>
        <source>%1 points</source>
        <translation>%1 Punkte</translation>
    </message>
    <message>
        <source>%1 byte</source>
        <translation>%1 Byte</translation>
    </message>
    <message>
        <source>%1 bytes</source>
        <translation>%1 Byte</translation>
    </message>
    <message>
        <source>%1 whole triangle</source>
        <translation>%1 ganzes Dreieck</translation>
    </message>
    <message>
        <source>%1 whole triangles</source>
        <translation>%1 ganze Dreiecke</translation>
    </message>
    <message>
        <source>%1 polygon</source>
        <translation>%1 Vieleck</translation>
    </message>
    <message>
        <source>%1 polygons</source>
        <translation>%1 Vielecke</translation>
    </message>
    <message>
        <source>%1 face</source>
        <translation>%1 Fläche</translation>
    </message>
    <message>
        <source>%1 faces</source>
        <translation>%1 Flächen</translation>
    </message>
    <message>
        <source>%1 corner</source>
        <translation>%1 Ecke</translation>
    </message>
    <message>
        <source>%1 corners</source>
        <translation>%1 Ecken</translation>
    </message>
    <message>
        <source>%1 to %2</source>
        <translation>%1 bis %2</translation>
    </message>
    <message>
        <source>%1 of %2 have coordinates that are not numbers</source>
        <translation>%1 von %2 haben Koordinaten, die keine Zahlen sind</translation>
    </message>
    <message>
        <source>%1 of %2 have coordinates that are farther than 10 km from the origin</source>
        <translation>%1 von %2 haben Koordinaten, die weiter als 10 km vom Ursprung sind</translation>
    </message>
    <message>
        <source>finite coordinates within 10 km</source>
        <translation>endliche Koordinaten innerhalb von 10 km</translation>
    </message>
    <message>
        <source>the file ends in the STL header</source>
        <translation>die Datei endet im Kopf der STL-Datei</translation>
    </message>
    <message>
        <source>the file ends in the header</source>
        <translation>die Datei endet in ihrem Kopf</translation>
    </message>
    <message>
        <source>at least %1 bytes</source>
        <translation>mindestens %1 Byte</translation>
    </message>
    <message>
        <source>at most %1</source>
        <translation>höchstens %1</translation>
    </message>
    <message>
        <source>the binary STL declares %1 but its %2 hold %3</source>
        <translation>die binäre STL-Datei kündigt %1 an, aber in ihren %2 sind nur %3</translation>
    </message>
    <message>
        <source>the file ends there: %1 of %2 lost</source>
        <translation>die Datei endet dort: %1 von %2 fehlen</translation>
    </message>
    <message>
        <source>the file ends after %1</source>
        <translation>die Datei endet nach %1</translation>
    </message>
    <message>
        <source>what came after %1 lost</source>
        <translation>was nach %1 kam, fehlt</translation>
    </message>
    <message>
        <source>the file ends in a line: that line and what came after it lost</source>
        <translation>die Datei endet mitten in einer Zeile: diese Zeile und was danach kam fehlen</translation>
    </message>
    <message>
        <source>too many elements</source>
        <translation>zu viele Elemente</translation>
    </message>
    <message>
        <source>%1 elements declared</source>
        <translation>%1 Elemente sind angekündigt</translation>
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
        <source>the vertex has fewer than three coordinates</source>
        <translation>der Eckpunkt hat weniger als drei Koordinaten</translation>
    </message>
    <message>
        <source>it uses point %1</source>
        <translation>verwendet den Punkt %1</translation>
    </message>
    <message>
        <source>no faces with a list of vertex indices</source>
        <translation>keine Flächen mit einer Liste von Eckpunkten</translation>
    </message>
    <message>
        <source>no vertices with x, y and z</source>
        <translation>keine Eckpunkte mit x, y und z</translation>
    </message>
    <message>
        <source>one of each</source>
        <translation>beides</translation>
    </message>
    <message>
        <source>vertex index %1 (%2 vertices so far)</source>
        <translation>der Eckpunkt mit der Nummer %1 (bis hier gibt es %2)</translation>
    </message>
    <message>
        <source>face %1 uses vertex %2</source>
        <translation>die Fläche %1 verwendet den Eckpunkt %2</translation>
    </message>
    <message>
        <source>a zero byte</source>
        <translation>ein Null-Byte</translation>
    </message>
    <message>
        <source>text</source>
        <translation>Text</translation>
    </message>
    <message>
        <source>the end of the line</source>
        <translation>das Ende der Zeile</translation>
    </message>
    <message>
        <source>the XML is broken: %1</source>
        <translation>das XML ist fehlerhaft: %1</translation>
    </message>
    <message>
        <source>well-formed XML to the end</source>
        <translation>fehlerfreies XML bis zum Ende</translation>
    </message>
    <message>
        <source>its mesh is larger than %1 MiB</source>
        <translation>die Oberfläche ist größer als %1 MiB</translation>
    </message>
    <message>
        <source>a mesh that fits its file&apos;s size</source>
        <translation>eine Oberfläche, die zur Größe der Datei passt</translation>
    </message>
    <message>
        <source>reading it takes more than %1 MiB of memory</source>
        <translation>sie zu lesen braucht mehr als %1 MiB Speicher</translation>
    </message>
    <message>
        <source>reading it took more than %1 s</source>
        <translation>sie zu lesen dauerte länger als %1 s</translation>
    </message>
    <message>
        <source>reading it took more than %1 s of processor time</source>
        <translation>sie zu lesen brauchte mehr als %1 s Rechenzeit</translation>
    </message>
    <message>
        <source>a mesh that can be read sooner</source>
        <translation>eine Oberfläche, die schneller zu lesen ist</translation>
    </message>
    <message>
        <source>the system ended the process that read it, perhaps for want of memory</source>
        <translation>das System beendete das Lesen, vielleicht aus Mangel an Speicher</translation>
    </message>
    <message>
        <source>a file that can be read</source>
        <translation>eine lesbare Datei</translation>
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
        <source>%1 open edge: the surface has holes or a rim</source>
        <translation>%1 offene Kante: die Oberfläche hat Löcher oder einen Rand</translation>
    </message>
    <message>
        <source>%1 open edges: the surface has holes or a rim</source>
        <translation>%1 offene Kanten: die Oberfläche hat Löcher oder einen Rand</translation>
    </message>
    <message>
        <source>%1 triangle without area left out</source>
        <translation>%1 Dreieck ohne Fläche weggelassen</translation>
    </message>
    <message>
        <source>%1 triangles without area left out</source>
        <translation>%1 Dreiecke ohne Fläche weggelassen</translation>
    </message>
    <message>
        <source>%1 duplicate triangle left out</source>
        <translation>%1 doppeltes Dreieck weggelassen</translation>
    </message>
    <message>
        <source>%1 duplicate triangles left out</source>
        <translation>%1 doppelte Dreiecke weggelassen</translation>
    </message>
    <message>
        <source>%1 triangle turned round to face the same way as the rest</source>
        <translation>%1 Dreieck gewendet, damit es zur selben Seite zeigt wie die übrigen</translation>
    </message>
    <message>
        <source>%1 triangles turned round to face the same way as the rest</source>
        <translation>%1 Dreiecke gewendet, damit sie zur selben Seite zeigen wie die übrigen</translation>
    </message>
    <message>
        <source>%1 edge shared by more than two triangles</source>
        <translation>%1 Kante gehört zu mehr als zwei Dreiecken</translation>
    </message>
    <message>
        <source>%1 edges shared by more than two triangles</source>
        <translation>%1 Kanten gehören zu mehr als zwei Dreiecken</translation>
    </message>
    <message>
        <source>%1 part without a consistent front</source>
        <translation>%1 Teil ohne einheitliche Vorderseite</translation>
    </message>
    <message>
        <source>%1 parts without a consistent front</source>
        <translation>%1 Teile ohne einheitliche Vorderseite</translation>
    </message>
    <message>
        <source>%1 part without an inside, touched from both sides</source>
        <translation>%1 Teil ohne Inneres, von beiden Seiten zu fühlen</translation>
    </message>
    <message>
        <source>%1 parts without an inside, touched from both sides</source>
        <translation>%1 Teile ohne Inneres, von beiden Seiten zu fühlen</translation>
    </message>
    <message>
        <source>%1 values of arrays differed by more than 10 % from another at the same vertex: the mean is used</source>
        <translation>%1 Werte wichen um mehr als 10 % von einem anderen am selben Eckpunkt ab: das Mittel gilt</translation>
    </message>
    <message>
        <source>no SPACE tag: coordinates taken as LPS</source>
        <translation>ohne Angabe SPACE: die Koordinaten gelten als LPS</translation>
    </message>
    <message>
        <source>%1 and %2 more file</source>
        <translation>%1 und %2 weitere Datei</translation>
    </message>
    <message>
        <source>%1 and %2 more files</source>
        <translation>%1 und %2 weitere Dateien</translation>
    </message>
    <message>
        <source>tagged SPACE=RAS: x and y negated to get LPS</source>
        <translation>Angabe SPACE=RAS: x und y umgekehrt, so dass es LPS ist</translation>
    </message>
    <message>
        <source>tagged SPACE=%1, but taken as %2, as was chosen</source>
        <translation>Angabe SPACE=%1, aber als %2 gelesen, wie gewählt wurde</translation>
    </message>
    <message>
        <source>taken as %1, as the scene file says; not as %2</source>
        <translation>als %1 gelesen, wie die Szene es sagt; nicht als %2</translation>
    </message>
    <message>
        <source>only %1 units wide, taken as %2; looks like %3: open with --unit %4</source>
        <translation>nur %1 Einheiten breit, als %2 gelesen; wahrscheinlich sind es %3: mit --unit %4 öffnen</translation>
    </message>
    <message>
        <source>%1 units wide, taken as %2; looks like %3: open with --unit %4</source>
        <translation>%1 Einheiten breit, als %2 gelesen; wahrscheinlich sind es %3: mit --unit %4 öffnen</translation>
    </message>
    <message>
        <source>metres</source>
        <translation>Meter</translation>
    </message>
    <message>
        <source>millimetres</source>
        <translation>Millimeter</translation>
    </message>
    <message>
        <source>larger ones</source>
        <translation>größere</translation>
    </message>
    <message>
        <source>%1 and %2 are the same surface twice</source>
        <translation>%1 und %2 sind zweimal dieselbe Oberfläche</translation>
    </message>
    <message>
        <source>%1 lies in %2 and is felt below it</source>
        <translation>%1 liegt in %2 und wird darunter gefühlt</translation>
    </message>
    <message>
        <source>%1 lies in %2, which is felt in the last of %3 layers: both are felt in that one</source>
        <translation>%1 liegt in %2, das in der letzten von %3 Schichten gefühlt wird: beide werden in dieser gefühlt</translation>
    </message>
    <message>
        <source>%1 seems to lie in %2, whose surface is open or inside out: it is not felt below it</source>
        <translation>%1 liegt wohl in %2, dessen Oberfläche offen oder umgestülpt ist: es wird nicht darunter gefühlt</translation>
    </message>
    <message>
        <source>colours not read: those of its %1</source>
        <translation>die Farben werden nicht gelesen: %1</translation>
    </message>
    <message>
        <source>changed since the scene was saved: found SHA-256 %1, expected %2; opened as it is now</source>
        <translation>geändert, seit die Szene gespeichert wurde: Prüfsumme %1, erwartet %2; geöffnet, wie es jetzt ist</translation>
    </message>
    <message>
        <source>is a list of 3D Slicer marks, not a Palpate scene: open the anatomy, then take the marks in with File &gt; Import findings</source>
        <translation>ist eine Liste von Marken aus 3D Slicer, keine Szene von Palpate: erst die Anatomie öffnen, dann die Marken mit Datei &gt; Befunde einlesen dazunehmen</translation>
    </message>
    <message>
        <source>is not a Palpate scene: found neither `version` nor `structures`; expected a file that Palpate saved (.palpate.json)</source>
        <translation>ist keine Szene von Palpate: weder `version` noch `structures` ist darin; erwartet: eine Datei, die Palpate gespeichert hat (.palpate.json)</translation>
    </message>
    <message>
        <source>version: found %1, expected at most %2: it was made by a newer Palpate</source>
        <translation>Version: gefunden %1, erwartet höchstens %2: eine neuere Fassung von Palpate hat sie geschrieben</translation>
    </message>
    <message>
        <source>no JSON object</source>
        <translation>kein JSON-Objekt</translation>
    </message>
    <message>
        <source>a scene as a JSON object</source>
        <translation>eine Szene als JSON-Objekt</translation>
    </message>
    <message>
        <source>an array</source>
        <translation>eine Liste</translation>
    </message>
    <message>
        <source>an object</source>
        <translation>ein Objekt</translation>
    </message>
    <message>
        <source>a text</source>
        <translation>ein Text</translation>
    </message>
    <message>
        <source>a number</source>
        <translation>eine Zahl</translation>
    </message>
    <message>
        <source>true or false</source>
        <translation>true oder false</translation>
    </message>
    <message>
        <source>an array of %1</source>
        <translation>eine Liste von %1</translation>
    </message>
    <message>
        <source>%1 numbers</source>
        <translation>%1 Zahlen</translation>
    </message>
    <message>
        <source>a whole number</source>
        <translation>eine ganze Zahl</translation>
    </message>
    <message>
        <source>a fraction</source>
        <translation>ein Bruch</translation>
    </message>
    <message>
        <source>nothing</source>
        <translation>nichts</translation>
    </message>
    <message>
        <source>none</source>
        <translation>nichts</translation>
    </message>
    <message>
        <source>the path of a mesh file</source>
        <translation>der Pfad einer Datei mit einer Oberfläche</translation>
    </message>
    <message>
        <source>the path of a recording</source>
        <translation>der Pfad einer Aufzeichnung</translation>
    </message>
    <message>
        <source>the name of a structure of this scene</source>
        <translation>der Name einer Struktur dieser Szene</translation>
    </message>
    <message>
        <source>one of %1</source>
        <translation>eines von: %1</translation>
    </message>
    <message>
        <source>no such file, expected a recording</source>
        <translation>die Datei ist nicht da, erwartet: eine Aufzeichnung</translation>
    </message>
    <message>
        <source>found no SQLite database, expected a recording</source>
        <translation>keine Aufzeichnung von Palpate (keine SQLite-Datenbank)</translation>
    </message>
    <message>
        <source>found another program&apos;s SQLite database, expected a Palpate recording</source>
        <translation>die Datenbank eines anderen Programms, erwartet: eine Aufzeichnung von Palpate</translation>
    </message>
    <message>
        <source>found a recording of version %1, expected at most %2: a newer Palpate made it</source>
        <translation>eine Aufzeichnung der Version %1, erwartet höchstens %2: eine neuere Fassung von Palpate hat sie geschrieben</translation>
    </message>
    <message>
        <source>found no tick with a hand, expected at least one</source>
        <translation>kein Augenblick mit einer Hand darin, erwartet: mindestens einer</translation>
    </message>
    <message>
        <source>damaged: %1</source>
        <translation>beschädigt: %1</translation>
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
        <source>the recording ended at %1 s because %2; what was felt after is not in it</source>
        <translation>die Aufzeichnung endete bei %1 s, weil %2; was danach gefühlt wurde, ist nicht darin</translation>
    </message>
    <message>
        <source>nothing was recorded because %1</source>
        <translation>nichts wurde aufgezeichnet, weil %1</translation>
    </message>
    <message>
        <source>the disk cannot be written (%1)</source>
        <translation>der Datenträger nicht beschrieben werden kann (%1)</translation>
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
        <source>%1 ticks were lost</source>
        <translation>%1 Augenblicke gingen verloren</translation>
    </message>
    <message>
        <source>cannot be recorded: the servo loop is not running</source>
        <translation>kann nicht aufgezeichnet werden: die Hand läuft nicht</translation>
    </message>
    <message>
        <source>cannot be recorded: the servo loop does not answer</source>
        <translation>kann nicht aufgezeichnet werden: die Hand antwortet nicht</translation>
    </message>
    <message>
        <source>found none of the surfaces that it was made on</source>
        <translation>keine der Oberflächen, auf denen sie gemacht wurde, ist da</translation>
    </message>
    <message>
        <source>it holds none and names no mesh</source>
        <translation>sie enthält keine und nennt keine</translation>
    </message>
    <message>
        <source>no such file, neither where it was nor beside the recording</source>
        <translation>die Datei ist nicht da, weder an ihrem Ort noch neben der Aufzeichnung</translation>
    </message>
    <message>
        <source>is another surface now than was recorded; opened as it is now</source>
        <translation>ist jetzt eine andere Oberfläche als die aufgezeichnete; geöffnet, wie sie jetzt ist</translation>
    </message>
    <message>
        <source>its recorded map is of another surface; it is not felt</source>
        <translation>die aufgezeichnete Karte gehört zu einer anderen Oberfläche; sie wird nicht gefühlt</translation>
    </message>
    <message>
        <source>what lumps below it made is of another surface; it is not felt</source>
        <translation>was Knoten darunter bewirkten, gehört zu einer anderen Oberfläche; es wird nicht gefühlt</translation>
    </message>
    <message>
        <source>the recording does not say what scene it was made on</source>
        <translation>die Aufzeichnung sagt nicht, auf welcher Szene sie gemacht wurde</translation>
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
        <source>the SpaceMouse is the hand now; choose another device for it first</source>
        <translation>die SpaceMouse ist jetzt die Hand; bitte erst ein anderes Gerät dafür wählen</translation>
    </message>
    <message>
        <source>no device is called %1</source>
        <translation>kein Gerät heißt %1</translation>
    </message>
    <message>
        <source>the simulated hand palpates what is in the middle of the view: found nothing palpable there</source>
        <translation>die simulierte Hand tastet, was in der Mitte der Ansicht ist: dort ist nichts zu fühlen</translation>
    </message>
    <message>
        <source>no recording is open whose motion could be felt anew</source>
        <translation>keine Aufzeichnung ist offen, deren Bewegung neu gefühlt werden könnte</translation>
    </message>
    <message>
        <source>the motion to play has no rows</source>
        <translation>die Bewegung, die gespielt werden soll, ist leer</translation>
    </message>
    <message>
        <source>the device could not be started: %1</source>
        <translation>das Gerät ließ sich nicht starten: %1</translation>
    </message>
    <message>
        <source>its driver failed</source>
        <translation>sein Treiber versagte</translation>
    </message>
    <message>
        <source>skipped, it hung when it was started</source>
        <translation>übergangen: beim Start blieb es hängen</translation>
    </message>
    <message>
        <source>skipped, it ended the process when it was started</source>
        <translation>übergangen: beim Start beendete es das Programm</translation>
    </message>
    <message>
        <source>skipped, it failed when it was started</source>
        <translation>übergangen: der Start misslang</translation>
    </message>
    <message>
        <source>skipped, %1 comes first</source>
        <translation>übergangen: %1 geht vor</translation>
    </message>
    <message>
        <source>CPU %1: this machine has no such CPU</source>
        <translation>Prozessor %1: diesen gibt es hier nicht</translation>
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
        <source>lumps felt through their organ: %1</source>
        <translation>Knoten, durch ihr Organ gefühlt: %1</translation>
    </message>
    <message>
        <source>it has %1 points; expected 2 to %2</source>
        <translation>es sind %1 Punkte; erwartet: 2 bis %2</translation>
    </message>
    <message>
        <source>it has more points; expected 2 to %1</source>
        <translation>es sind mehr Punkte; erwartet: 2 bis %1</translation>
    </message>
    <message>
        <source>left out, its surface is open: it has no volume to be felt</source>
        <translation>weggelassen: die Oberfläche ist offen, es gibt kein Volumen zu fühlen</translation>
    </message>
    <message>
        <source>left out, its surface is inside out</source>
        <translation>weggelassen: die Oberfläche ist umgestülpt</translation>
    </message>
    <message>
        <source>left out, it lies outside %1</source>
        <translation>weggelassen: liegt außerhalb von %1</translation>
    </message>
    <message>
        <source>%1 and %2 reach into each other: where both are felt is not judged</source>
        <translation>%1 und %2 reichen ineinander: wo beide zu fühlen sind, wird nicht beurteilt</translation>
    </message>
    <message>
        <source>%1 was read as %2</source>
        <translation>%1 wurde als %2 gelesen</translation>
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
        <source>polygon %1</source>
        <translation>Vieleck %1</translation>
    </message>
    <message>
        <source>point %1</source>
        <translation>Punkt %1</translation>
    </message>
    <message>
        <source>header</source>
        <translation>Kopf</translation>
    </message>
    <message>
        <source>structures</source>
        <translation>Strukturen</translation>
    </message>
    <message>
        <source>%1; expected %2</source>
        <translation>%1; erwartet: %2</translation>
    </message>
    <message>
        <source>found %1, expected %2</source>
        <translation>gefunden: %1, erwartet: %2</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>%1 (in English)</source>
        <extracomment>around a line that has no translation</extracomment>
        <translation>%1 (auf Englisch)</translation>
    </message>
    <message>
        <source>%1 of %2 have coordinates that are not numbers (first: triangle %3)</source>
        <translation>%1 von %2 haben Koordinaten, die keine Zahlen sind (als erstes Dreieck %3)</translation>
    </message>
    <message>
        <source>%1 of %2 have coordinates that are farther than 10 km from the origin (first: triangle %3)</source>
        <translation>%1 von %2 haben Koordinaten, die weiter als 10 km vom Ursprung sind (als erstes Dreieck %3)</translation>
    </message>
    <message>
        <source>the SpaceMouse moves the view or presses; switch that off first</source>
        <translation>die SpaceMouse bewegt die Ansicht oder drückt; das zuerst ausschalten</translation>
    </message>
    <message>
        <source>its triangles are wider than a finger&apos;s contact: what the hand feels of its lumps differs by up to %1 % from what is shown; a finer mesh mends it</source>
        <translation>seine Dreiecke sind breiter als die Kontaktfläche eines Fingers: was die Hand von seinen Knoten fühlt, weicht um bis zu %1 % vom Gezeigten ab; ein feineres Netz behebt das</translation>
    </message>
    <message>
        <source>its volume is larger than %1 MiB</source>
        <translation>sein Volumen ist größer als %1 MiB</translation>
    </message>
    <message>
        <source>a volume that fits its file&apos;s size</source>
        <translation>ein Volumen, das zur Größe der Datei passt</translation>
    </message>
    <message>
        <source>a volume that fits</source>
        <translation>ein Volumen, das hineinpasst</translation>
    </message>
    <message>
        <source>a volume that can be read sooner</source>
        <translation>ein Volumen, das schneller zu lesen ist</translation>
    </message>
    <message>
        <source>the process that read it gave up (exit code %1)</source>
        <translation>der Prozess, der es las, hat aufgegeben (Rückgabewert %1)</translation>
    </message>
    <message>
        <source>reading was cancelled</source>
        <translation>das Lesen wurde abgebrochen</translation>
    </message>
    <message>
        <source>a volume</source>
        <translation>ein Volumen</translation>
    </message>
    <message>
        <source>a readable volume</source>
        <translation>ein lesbares Volumen</translation>
    </message>
    <message>
        <source>it does not end</source>
        <translation>er endet nicht</translation>
    </message>
    <message>
        <source>a header that says where the voxels are</source>
        <translation>ein Dateikopf, der sagt, wo die Voxel stehen</translation>
    </message>
    <message>
        <source>it does not end with its last tag</source>
        <translation>es endet nicht mit seinem letzten Tag</translation>
    </message>
    <message>
        <source>`&lt;/VTKFile&gt;` at the end</source>
        <translation>`&lt;/VTKFile&gt;` am Ende</translation>
    </message>
    <message>
        <source>its compressed voxels are cut off or broken</source>
        <translation>seine komprimierten Voxel sind abgeschnitten oder beschädigt</translation>
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
        <source>%1 voxels declared</source>
        <translation>%1 Voxel sind angekündigt</translation>
    </message>
    <message>
        <source>as many as its %1 bytes can hold</source>
        <translation>so viele, wie in seine %1 Bytes passen</translation>
    </message>
    <message>
        <source>an axis without a voxel</source>
        <translation>eine Achse ohne Voxel</translation>
    </message>
    <message>
        <source>at least one along each axis</source>
        <translation>mindestens eines entlang jeder Achse</translation>
    </message>
    <message>
        <source>%1 components a voxel</source>
        <translation>%1 Komponenten je Voxel</translation>
    </message>
    <message>
        <source>no numbers</source>
        <translation>keine Zahlen</translation>
    </message>
    <message>
        <source>one number for each voxel</source>
        <translation>eine Zahl für jedes Voxel</translation>
    </message>
    <message>
        <source>axes or distances of its voxels that say no place</source>
        <translation>Achsen oder Abstände seiner Voxel, die keinen Ort angeben</translation>
    </message>
    <message>
        <source>three directions that are not in a plane, and distances that are not 0</source>
        <translation>drei Richtungen, die nicht in einer Ebene liegen, und Abstände, die nicht 0 sind</translation>
    </message>
    <message>
        <source>directions of its axes that can&apos;t be read</source>
        <translation>Richtungen seiner Achsen, die nicht lesbar sind</translation>
    </message>
    <message>
        <source>three vectors that are not in a plane</source>
        <translation>drei Vektoren, die nicht in einer Ebene liegen</translation>
    </message>
    <message>
        <source>voxels in another encoding</source>
        <translation>Voxel in einer anderen Kodierung</translation>
    </message>
    <message>
        <source>`raw` or `gzip`</source>
        <translation>`raw` oder `gzip`</translation>
    </message>
    <message>
        <source>the process that read it crashed (%1)</source>
        <translation>der Prozess, der es las, ist abgestürzt (%1)</translation>
    </message>
    <message>
        <source>%1 twice</source>
        <translation>%1 zweimal</translation>
    </message>
    <message>
        <source>each field once</source>
        <translation>jedes Feld einmal</translation>
    </message>
    <message>
        <source>no dimension before them</source>
        <translation>keine Dimension davor</translation>
    </message>
    <message>
        <source>a dimension</source>
        <translation>eine Dimension</translation>
    </message>
    <message>
        <source>three counts of voxels</source>
        <translation>drei Anzahlen von Voxeln</translation>
    </message>
    <message>
        <source>the name of one file</source>
        <translation>der Name einer Datei</translation>
    </message>
    <message>
        <source>no header of NIfTI</source>
        <translation>kein NIfTI-Kopf</translation>
    </message>
    <message>
        <source>348 or 540 bytes of it</source>
        <translation>348 oder 540 Byte davon</translation>
    </message>
    <message>
        <source>voxels of kind %1</source>
        <translation>Voxel der Art %1</translation>
    </message>
    <message>
        <source>one of NIfTI&apos;s kinds, as 16 for float</source>
        <translation>eine der Arten von NIfTI, etwa 16 für float</translation>
    </message>
    <message>
        <source>%1 axes</source>
        <translation>%1 Achsen</translation>
    </message>
    <message>
        <source>1 to 7</source>
        <translation>1 bis 7</translation>
    </message>
    <message>
        <source>a byte of 0 in its text</source>
        <translation>ein Byte 0 im Text</translation>
    </message>
    <message>
        <source>a header of text alone</source>
        <translation>ein Kopf nur aus Text</translation>
    </message>
    <message>
        <source>what is not one number</source>
        <translation>keine einzelne Zahl</translation>
    </message>
    <message>
        <source>%1 dimension</source>
        <translation>%1 Dimension</translation>
    </message>
    <message>
        <source>%1 dimensions</source>
        <translation>%1 Dimensionen</translation>
    </message>
    <message>
        <source>1 to 4</source>
        <translation>1 bis 4</translation>
    </message>
    <message>
        <source>value %1 is %2</source>
        <translation>Wert %1 ist %2</translation>
    </message>
    <message>
        <source>a number that an Int32 can hold</source>
        <translation>eine Zahl, die in ein Int32 passt</translation>
    </message>
    <message>
        <source>a number that a %1 can hold</source>
        <translation>eine Zahl, die in ein %1 passt</translation>
    </message>
    <message>
        <source>a blank or a new line behind it</source>
        <translation>ein Leerzeichen oder eine neue Zeile dahinter</translation>
    </message>
    <message>
        <source>%1: %2: this version does not know this field; it is kept, but not used</source>
        <translation>%1: %2: Dieses Feld ist dieser Version unbekannt; es bleibt erhalten, wird aber nicht verwendet</translation>
    </message>
    <message>
        <source>File too large</source>
        <translation>Datei zu groß</translation>
    </message>
    <message>
        <source>Disk quota exceeded</source>
        <translation>Speicherkontingent überschritten</translation>
    </message>
    <message>
        <source>Input/output error</source>
        <translation>Ein-/Ausgabefehler</translation>
    </message>
    <message>
        <source>Not a directory</source>
        <translation>Kein Ordner</translation>
    </message>
    <message>
        <source>File name too long</source>
        <translation>Dateiname zu lang</translation>
    </message>
    <message>
        <source>not a file</source>
        <translation>keine Datei</translation>
    </message>
    <message>
        <source>there is a file of this name; choose another name</source>
        <translation>es gibt eine Datei dieses Namens; wählen Sie einen anderen Namen</translation>
    </message>
    <message>
        <source>another program is recording into it; choose another name</source>
        <translation>ein anderes Programm zeichnet darin auf; wählen Sie einen anderen Namen</translation>
    </message>
    <message>
        <source>the file %1 would be taken for a part of it; move that away or choose another name</source>
        <translation>die Datei %1 würde für einen Teil davon gehalten; verschieben Sie sie oder wählen Sie einen anderen Namen</translation>
    </message>
    <message>
        <source>it as input and output</source>
        <translation>dasselbe als Ein- und Ausgabe</translation>
    </message>
    <message>
        <source>it as output and a file of %1</source>
        <translation>dasselbe als Ausgabe und Datei von %1</translation>
    </message>
    <message>
        <source>another name for the output</source>
        <translation>einen anderen Namen für die Ausgabe</translation>
    </message>
    <message>
        <source>the touched surface goes there; found another file, expected none or an older export. Choose another name</source>
        <translation>dorthin kommt die berührte Oberfläche; dort liegt eine andere Datei, erwartet wurde keine oder ein älterer Export. Wählen Sie einen anderen Namen</translation>
    </message>
    <message>
        <source>%1 closed part looks inside out: touched from within only, unless turned outwards</source>
        <translation>%1 geschlossener Teil sieht umgestülpt aus: nur von innen berührbar, solange er nicht umgedreht wird</translation>
    </message>
    <message>
        <source>%1 closed parts look inside out: touched from within only, unless turned outwards</source>
        <translation>%1 geschlossene Teile sehen umgestülpt aus: nur von innen berührbar, solange sie nicht umgedreht werden</translation>
    </message>
    <message>
        <source>staircase of about %1 × %2 × %3 mm voxels (%4 % of the area in %5 directions)</source>
        <translation>Treppe aus Voxeln von etwa %1 × %2 × %3 mm (%4 % der Fläche in %5 Richtungen)</translation>
    </message>
    <message>
        <source>smoothed: vertices moved by at most %1 mm, volume %2 %</source>
        <translation>geglättet: Eckpunkte höchstens um %1 mm verschoben, Volumen %2 %</translation>
    </message>
    <message>
        <source>smoothed: vertices moved by at most %1 mm</source>
        <translation>geglättet: Eckpunkte höchstens um %1 mm verschoben</translation>
    </message>
    <message>
        <source>surface &quot;smooth&quot;: curved facets are not available in this version; felt and drawn as facets</source>
        <translation>Oberfläche „smooth“: Gekrümmte Facetten gibt es in dieser Version nicht; als Facetten gefühlt und gezeichnet</translation>
    </message>
    <message>
        <source>%1 and %2 come within %3 mm of each other at (%4, %5, %6) without touching: a point falls into the gap, a fingertip of 0.5 mm or more rides over it</source>
        <translation>%1 und %2 kommen sich bei (%4, %5, %6) auf %3 mm nahe, ohne sich zu berühren: Ein Punkt fällt in den Spalt, eine Fingerspitze ab 0,5 mm gleitet darüber</translation>
    </message>
    <message>
        <source>found the journal of several databases, which names another file to be deleted; Palpate writes none, so this was not made by Palpate; nothing was opened. Move it away to read the recording as it is</source>
        <translation>das Journal mehrerer Datenbanken, das eine andere Datei zum Löschen nennt; Palpate schreibt keines, es stammt also nicht von Palpate; nichts wurde geöffnet. Verschieben Sie es, um die Aufzeichnung so zu lesen, wie sie ist</translation>
    </message>
    <message>
        <source>found something else than a file, expected the journal of a recording; nothing was opened. Move it away to read the recording as it is</source>
        <translation>keine Datei, erwartet wurde das Journal einer Aufzeichnung; nichts wurde geöffnet. Verschieben Sie es, um die Aufzeichnung so zu lesen, wie sie ist</translation>
    </message>
    <message>
        <source>found a database with a write-ahead log, expected one with a rollback journal, as Palpate writes it: another program changed it</source>
        <translation>eine Datenbank mit Write-Ahead-Log, erwartet wurde eine mit Rollback-Journal, wie Palpate sie schreibt: Ein anderes Programm hat sie geändert</translation>
    </message>
    <message>
        <source>found %1, expected %2: not made by Palpate, or damaged (palpate session recover gathers what is whole)</source>
        <translation>gefunden: %1, erwartet: %2: nicht von Palpate erstellt oder beschädigt (palpate session recover rettet, was heil ist)</translation>
    </message>
    <message>
        <source>how many times as stiff as %1 it is, is not known, so no verdict is given; expected a ratio, as --ratio &quot;%2=R&quot; or `young_ratio` in a scene file. Published: %3</source>
        <translation>wievielmal so steif wie %1 es ist, ist nicht bekannt, daher kein Urteil; erwartet ein Verhältnis, als --ratio &quot;%2=R&quot; oder `young_ratio` in einer Szenendatei. Veröffentlicht: %3</translation>
    </message>
    <message>
        <source>%1 and %2 touch in one layer and differ %3-fold in stiffness: the force steps at the seam</source>
        <translation>%1 und %2 berühren sich in einer Schicht, und ihre Steifigkeiten unterscheiden sich um das %3-Fache: an der Naht springt die Kraft</translation>
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
        <source>half below %1, 99 % below %2</source>
        <translation>die Hälfte unter %1, 99 % unter %2</translation>
    </message>
    <message>
        <source>%1, %2 refused, lost %3 times</source>
        <translation>%1, %2 abgewiesen, %3-mal verloren</translation>
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
        <source>Touch is computed %1 times a second instead of %2: forces may stutter. Close other programs.</source>
        <translation>Das Tasten wird %1-mal statt %2-mal je Sekunde berechnet: Kräfte können stocken. Schließen Sie andere Programme.</translation>
    </message>
    <message>
        <source>force may stutter</source>
        <translation>Kraft kann stocken</translation>
    </message>
    <message>
        <source>The system does not give touch its time first: other programs may make the force stutter. The list of messages (F4) says how to permit it.</source>
        <translation>Das System gibt dem Tasten keinen Vorrang: andere Programme können die Kraft stocken lassen. Die Liste der Meldungen (F4) sagt, wie es erlaubt wird.</translation>
    </message>
    <message>
        <source>running well</source>
        <translation>läuft gut</translation>
    </message>
    <message>
        <source>Touch is computed %1 times a second, as it should be.</source>
        <translation>Das Tasten wird %1-mal je Sekunde berechnet, wie es sein soll.</translation>
    </message>
    <message>
        <source>Energy observer: what the hand has put into the touched tissue and not got back [mJ].
Below zero the program would give more than it took; damping then takes it away.</source>
        <translation>Energiebeobachter: was die Hand in das berührte Gewebe gesteckt und nicht zurückbekommen hat [mJ].
Unter null gäbe das Programm mehr, als es nahm; Dämpfung nimmt es dann weg.</translation>
    </message>
    <message>
        <source>What the servo thread was granted</source>
        <translation>Was dem Servo-Thread gewährt wurde</translation>
    </message>
    <message>
        <source>Constraints</source>
        <translation>Zwangsbedingungen</translation>
    </message>
    <message>
        <source>Active constraints: planes of the surface that hold the hand back, at most 3</source>
        <translation>Aktive Zwangsbedingungen: Ebenen der Oberfläche, die die Hand zurückhalten, höchstens 3</translation>
    </message>
    <message>
        <source>Solver</source>
        <translation>Löser</translation>
    </message>
    <message>
        <source>Time of one tick in the solver, of ticks with a hand</source>
        <translation>Zeit eines Takts im Löser, aus Takten mit Hand</translation>
    </message>
    <message>
        <source>Measured rate</source>
        <translation>Gemessener Takt</translation>
    </message>
    <message>
        <source>Ticks of the servo thread a second, over the last half second [kHz]</source>
        <translation>Takte des Servo-Threads je Sekunde, über die letzte halbe Sekunde [kHz]</translation>
    </message>
    <message>
        <source>Jitter</source>
        <translation>Jitter</translation>
    </message>
    <message>
        <source>How far the time from tick to tick is from the period; 99.9 % of the ticks stay below</source>
        <translation>Wie weit die Zeit von Takt zu Takt von der Periode abweicht; 99,9 % der Takte bleiben darunter</translation>
    </message>
    <message>
        <source>Late ticks</source>
        <translation>Verspätete Takte</translation>
    </message>
    <message>
        <source>Ticks that ended after their time, of all since the loop began; periods left out for it</source>
        <translation>Takte, die nach ihrer Zeit endeten, von allen seit Beginn der Schleife; Perioden, die deshalb ausfielen</translation>
    </message>
    <message>
        <source>Dropped ticks</source>
        <translation>Verlorene Takte</translation>
    </message>
    <message>
        <source>Ticks that were felt but are not in this recording, because the disk was slow</source>
        <translation>Takte, die gefühlt wurden, aber in dieser Aufzeichnung fehlen, weil der Datenträger langsam war</translation>
    </message>
    <message>
        <source>Energy</source>
        <translation>Energie</translation>
    </message>
    <message>
        <source>Energy observer: what the hand has put into the touched tissue and not got back [mJ]</source>
        <translation>Energiebeobachter: was die Hand in das berührte Gewebe gesteckt und nicht zurückbekommen hat [mJ]</translation>
    </message>
    <message>
        <source>Damping added</source>
        <translation>Dämpfung zusätzlich</translation>
    </message>
    <message>
        <source>Force that the passivity controller adds against the movement [N]</source>
        <translation>Kraft, die der Passivitätsregler gegen die Bewegung hinzufügt [N]</translation>
    </message>
    <message>
        <source>Device round trip</source>
        <translation>Umlaufzeit des Geräts</translation>
    </message>
    <message>
        <source>From a report of the device received to the force that answers it written</source>
        <translation>Vom Empfang einer Meldung des Geräts bis zum Schreiben der Kraft, die ihr antwortet</translation>
    </message>
    <message>
        <source>Delay</source>
        <translation>Verzögerung</translation>
    </message>
    <message>
        <source>After which the force is taken to act: it bounds the stiffness that is stable</source>
        <translation>Nach der die Kraft als wirkend gilt: sie begrenzt die Steifigkeit, die stabil ist</translation>
    </message>
    <message>
        <source>Device reports</source>
        <translation>Gerätemeldungen</translation>
    </message>
    <message>
        <source>Received, of those not to be believed, and how often the device was lost</source>
        <translation>Empfangen, davon unglaubwürdig, und wie oft das Gerät verloren ging</translation>
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
        <source>Ticks a second. A faster loop holds stiffer tissue where the device keeps up; see the jitter.</source>
        <translation>Takte je Sekunde. Eine schnellere Schleife hält steiferes Gewebe, wo das Gerät mitkommt; siehe Jitter.</translation>
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
        <source>CPU %1 alone</source>
        <translation>Nur CPU %1</translation>
    </message>
    <message>
        <source>CPU of the servo loop</source>
        <translation>CPU der Servoschleife</translation>
    </message>
    <message>
        <source>Where the servo loop runs. One CPU alone helps where it is kept free of everything else; elsewhere &quot;Any&quot; lets
the loop go where there is room.</source>
        <translation>Wo die Servoschleife läuft. Eine CPU allein hilft, wo sie von allem anderen frei gehalten wird; sonst lässt „Beliebig“
die Schleife laufen, wo Platz ist.</translation>
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
        <source>%1 of %2, %3 left out</source>
        <translation>%1 von %2, %3 ausgefallen</translation>
    </message>
    <message>
        <source>%1 mJ</source>
        <translation>%1 mJ</translation>
    </message>
    <message>
        <source>%1 N</source>
        <translation>%1 N</translation>
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
        <source>Felt when %1
(estimate)</source>
        <translation>Tastbar, %1
(Schätzung)</translation>
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
        <source>7 %: half of that</source>
        <translation>7 %: die Hälfte davon</translation>
    </message>
    <message>
        <source>14 %: a trained hand tells</source>
        <translation>14 %: geübte Hand spürt es</translation>
    </message>
    <message>
        <source>28 %: plainly felt</source>
        <translation>28 %: deutlich tastbar</translation>
    </message>
    <message>
        <source>%1 %: most here</source>
        <translation>%1 %: am meisten hier</translation>
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
        <source>Times as stiff</source>
        <translation>Wievielmal so steif</translation>
    </message>
    <message>
        <source>Least cover</source>
        <translation>Kleinste Deckung</translation>
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
        <source>Lumps and whether a hand finds them</source>
        <translation>Knoten und ob eine Hand sie findet</translation>
    </message>
    <message>
        <source>How deep the finger is pressed in</source>
        <translation>Wie tief der Finger eingedrückt ist</translation>
    </message>
    <message>
        <source>Coloured as pressed %1 mm</source>
        <translation>Gefärbt wie %1 mm eingedrückt</translation>
    </message>
    <message>
        <source>Coloured as touched lightly</source>
        <translation>Gefärbt wie leicht berührt</translation>
    </message>
    <message>
        <source>Show me the best place</source>
        <translation>Die beste Stelle zeigen</translation>
    </message>
    <message>
        <source>How many times as stiff as its organ the lump is</source>
        <translation>Wievielmal so steif wie sein Organ der Knoten ist</translation>
    </message>
    <message>
        <source>Where the lump&apos;s stiffness comes from</source>
        <translation>Woher die Steifigkeit des Knotens kommt</translation>
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
        <source>by</source>
        <translation>zu</translation>
    </message>
    <message>
        <source>Being computed…</source>
        <translation>Wird berechnet…</translation>
    </message>
    <message>
        <source>%1 mm</source>
        <translation>%1 mm</translation>
    </message>
    <message>
        <source>lies open</source>
        <translation>liegt frei</translation>
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
        <source>Times as stiff as its organ:</source>
        <translation>Wievielmal so steif wie sein Organ:</translation>
    </message>
    <message>
        <source>%1, times as stiff as %2:</source>
        <translation>%1, wievielmal so steif wie %2:</translation>
    </message>
    <message>
        <source>Stiffness of %1</source>
        <translation>Steifigkeit von %1</translation>
    </message>
    <message>
        <source>No place over this lump can be judged.</source>
        <translation>Keine Stelle über diesem Knoten lässt sich beurteilen.</translation>
    </message>
    <message>
        <source>By tissues or names</source>
        <translation>Nach Gewebe oder Namen</translation>
    </message>
    <message>
        <source>As published: %1, %2</source>
        <translation>Wie veröffentlicht: %1, %2</translation>
    </message>
    <message>
        <source>type it, or choose one that is published</source>
        <translation>eingeben oder einen veröffentlichten Wert wählen</translation>
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
        <source>a trained hand tells it</source>
        <translation>eine geübte Hand spürt es</translation>
    </message>
    <message>
        <source>below what a trained hand tells</source>
        <translation>weniger, als eine geübte Hand spürt</translation>
    </message>
    <message>
        <source>the surface bends too much</source>
        <translation>die Oberfläche ist zu stark gekrümmt</translation>
    </message>
    <message>
        <source>the organ is too thin</source>
        <translation>das Organ ist zu dünn</translation>
    </message>
    <message>
        <source>lumps reach into each other</source>
        <translation>Knoten reichen ineinander</translation>
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
        <source>no lump is felt here</source>
        <translation>hier ist kein Knoten tastbar</translation>
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
        <source>%1 (at %2: %3; at %4: %5)</source>
        <translation>%1 (bei %2: %3; bei %4: %5)</translation>
    </message>
    <message>
        <source>not known</source>
        <translation>nicht bekannt</translation>
    </message>
    <message>
        <source>%1 (at %2 times as stiff)</source>
        <translation>%1 (bei %2-facher Steifigkeit)</translation>
    </message>
</context>
<context>
    <name>palpate::ui::FindingsModel</name>
    <message>
        <source>%1: %2 N, %3 mm deep</source>
        <translation>%1: %2 N, %3 mm tief</translation>
    </message>
    <message>
        <source>felt %1 N/mm</source>
        <translation>gefühlt %1 N/mm</translation>
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
        <source>Number, as in the view</source>
        <translation>Nummer, wie in der Ansicht</translation>
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
        <source>Size across, as you judge it [mm]</source>
        <translation>Durchmesser nach Ihrem Urteil [mm]</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Größe</translation>
    </message>
    <message>
        <source>N</source>
        <translation>N</translation>
    </message>
    <message>
        <source>mm</source>
        <translation>mm</translation>
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
        <source>Size: found “%1”, expected millimetres as %2.</source>
        <translation>Größe: „%1“ gefunden, erwartet sind Millimeter wie %2.</translation>
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
        <source>The structure that was felt, and the organ that it lies in</source>
        <translation>Die gefühlte Struktur und ihr Organ</translation>
    </message>
    <message>
        <source>Force of this structure when it was marked [N]</source>
        <translation>Kraft dieser Struktur beim Markieren [N]</translation>
    </message>
    <message>
        <source>Depth in this structure when it was marked [mm]</source>
        <translation>Tiefe in dieser Struktur beim Markieren [mm]</translation>
    </message>
</context>
<context>
    <name>palpate::ui::FindingsPanel</name>
    <message>
        <source>Findings and notes</source>
        <translation>Befunde und Notizen</translation>
    </message>
    <message>
        <source>No finding yet. Press on a place and mark it with M; N writes a note without a place.</source>
        <translation>Noch kein Befund. Auf eine Stelle drücken und sie mit M markieren; N schreibt eine Notiz ohne Stelle.</translation>
    </message>
    <message>
        <source>Write a note (N), Enter keeps it</source>
        <translation>Notiz schreiben (N), Enter behält sie</translation>
    </message>
    <message>
        <source>New note without a place</source>
        <translation>Neue Notiz ohne Stelle</translation>
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
        <source>Force in newton</source>
        <translation>Kraft in Newton</translation>
    </message>
    <message>
        <source>%1 N of %2 N</source>
        <translation>%1 N von %2 N</translation>
    </message>
</context>
<context>
    <name>palpate::ui::ForceTimeline</name>
    <message>
        <source>Timeline of the recording&apos;s force</source>
        <translation>Zeitachse der Kraft in der Aufzeichnung</translation>
    </message>
    <message>
        <source>Force [N] over the recording. Click or drag to go there; ← and → step 0.1 s, Home and End.</source>
        <translation>Kraft [N] über die Aufzeichnung. Klicken oder ziehen, um dorthin zu gehen; ← und → gehen um 0,1 s, dazu Pos1 und Ende.</translation>
    </message>
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
</context>
<context>
    <name>palpate::ui::HandControl</name>
    <message>
        <source>%1; any is used</source>
        <translation>%1; jede CPU ist möglich</translation>
    </message>
    <message>
        <source>Touch the place, point at it or mark it as a finding (M) first.</source>
        <translation>Berühren Sie erst die Stelle, zeigen Sie darauf oder markieren Sie sie als Befund (M).</translation>
    </message>
    <message>
        <source>The whole scene</source>
        <translation>Die ganze Szene</translation>
    </message>
    <message>
        <source>10 mm where the hand touches</source>
        <translation>10 mm, wo die Hand berührt</translation>
    </message>
    <message>
        <source>10 mm under the pointer</source>
        <translation>10 mm unter dem Zeiger</translation>
    </message>
    <message>
        <source>10 mm about finding %1</source>
        <translation>10 mm um Befund %1</translation>
    </message>
    <message>
        <source>Nothing is shown that the hand&apos;s space could be zoomed to.</source>
        <translation>Nichts wird gezeigt, worauf der Raum der Hand gezoomt werden könnte.</translation>
    </message>
    <message>
        <source>%1 fills the hand&apos;s space. The hand stays where it touches; Centre brings it to the middle.</source>
        <translation>%1 füllt den Raum der Hand. Die Hand bleibt, wo sie berührt; „Mitte“ bringt sie in die Mitte.</translation>
    </message>
    <message>
        <source>%1 fills the hand&apos;s space.</source>
        <translation>%1 füllt den Raum der Hand.</translation>
    </message>
</context>
<context>
    <name>palpate::ui::HandPanel</name>
    <message>
        <source>Inside %1, which is felt from outside: bring the hand out towards you first.</source>
        <translation>Innerhalb von %1 (von außen gefühlt): führen Sie die Hand erst zu sich heraus.</translation>
    </message>
    <message>
        <source>As it lies: the device&apos;s millimetres are the scene&apos;s.</source>
        <translation>Wie sie liegt: die Millimeter des Geräts sind die der Szene.</translation>
    </message>
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
        <source>Millimetres of the scene for a millimetre of the device</source>
        <translation>Millimeter der Szene für einen Millimeter des Geräts</translation>
    </message>
    <message>
        <source>The picture</source>
        <translation>Das Bild</translation>
    </message>
    <message>
        <source>The patient</source>
        <translation>Der Patient</translation>
    </message>
    <message>
        <source>Nothing: as it lies</source>
        <translation>Nichts: wie es liegt</translation>
    </message>
    <message>
        <source>What the device turns with</source>
        <translation>Womit sich das Gerät dreht</translation>
    </message>
    <message>
        <source>Turns with</source>
        <translation>Dreht mit</translation>
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
        <source>Use of button %1</source>
        <translation>Verwendung von Taste %1</translation>
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
        <source>The first two buttons change places</source>
        <translation>Die ersten beiden Tasten tauschen ihren Platz</translation>
    </message>
    <message>
        <source>While held the device moves and the hand in the scene stays; the key C switches it</source>
        <translation>Solange sie gehalten wird, bewegt sich das Gerät und die Hand in der Szene bleibt; die Taste C schaltet um</translation>
    </message>
    <message>
        <source>Force on the hand %1 N of %2 N</source>
        <translation>Kraft auf die Hand %1 N von %2 N</translation>
    </message>
    <message>
        <source>No motors: the force is shown, not felt, and tissue may be as stiff as you like.</source>
        <translation>Keine Motoren: die Kraft wird angezeigt, nicht gefühlt, und Gewebe darf beliebig steif sein.</translation>
    </message>
    <message>
        <source>This device can show tissue up to %1 N/mm.</source>
        <translation>Dieses Gerät kann Gewebe bis %1 N/mm darstellen.</translation>
    </message>
    <message>
        <source>At the edge of the hand&apos;s space: bring the device back to its middle. The hand in the scene stays until then.</source>
        <translation>Am Rand des Raums der Hand: führen Sie das Gerät zurück in seine Mitte. Bis dahin bleibt die Hand in der Szene.</translation>
    </message>
    <message>
        <source>Lifted: the device moves, the hand in the scene stays.</source>
        <translation>Angehoben: das Gerät bewegt sich, die Hand in der Szene bleibt.</translation>
    </message>
    <message>
        <source>%1 fills the hand&apos;s space: 1 mm of the device is %2 mm of the scene.</source>
        <translation>%1 füllt den Raum der Hand: 1 mm des Geräts ist %2 mm der Szene.</translation>
    </message>
    <message>
        <source>Stiffest tissue that can be shown</source>
        <translation>Steifstes Gewebe, das sich darstellen lässt</translation>
    </message>
    <message>
        <source>Everything</source>
        <translation>Alles</translation>
    </message>
    <message>
        <source>The device&apos;s whole way then goes through all that is shown (W)</source>
        <translation>Der ganze Weg des Geräts führt dann durch alles Gezeigte (W)</translation>
    </message>
    <message>
        <source>Organ</source>
        <translation>Organ</translation>
    </message>
    <message>
        <source>The device&apos;s whole way then goes through the organ that is touched; else the one under the pointer or selected (O)</source>
        <translation>Der ganze Weg des Geräts führt dann durch das berührte Organ; sonst durch das unter dem Zeiger oder das gewählte (O)</translation>
    </message>
    <message>
        <source>Lump</source>
        <translation>Knoten</translation>
    </message>
    <message>
        <source>The device&apos;s whole way is then 10 mm: where the hand touches, else under the pointer, else about the newest finding (L)</source>
        <translation>Der ganze Weg des Geräts ist dann 10 mm: wo die Hand berührt, sonst unter dem Zeiger, sonst um den neuesten Befund (L)</translation>
    </message>
    <message>
        <source>Zoom the hand&apos;s space to</source>
        <translation>Raum der Hand zoomen auf</translation>
    </message>
    <message>
        <source>What fills the hand&apos;s space</source>
        <translation>Was den Raum der Hand füllt</translation>
    </message>
    <message>
        <source>The picture: right is right in the view, however it is turned.
The patient: right is to the patient&apos;s left, up is to the head.
Nothing: the device&apos;s coordinates are the scene&apos;s, without scale, and the hand cannot be lifted.</source>
        <translation>Das Bild: rechts ist rechts in der Ansicht, wie auch immer sie gedreht ist.
Der Patient: rechts ist zur Linken des Patienten, oben zum Kopf.
Nichts: die Koordinaten des Geräts sind die der Szene, ohne Maßstab, und die Hand lässt sich nicht anheben.</translation>
    </message>
    <message>
        <source>Lift the hand</source>
        <translation>Hand anheben</translation>
    </message>
    <message>
        <source>Puts the middle of the device&apos;s way in the middle of what the hand&apos;s space is zoomed to</source>
        <translation>Legt die Mitte des Wegs des Geräts in die Mitte dessen, worauf der Raum der Hand gezoomt ist</translation>
    </message>
    <message>
        <source>Depth (wheel)</source>
        <translation>Tiefe (Rad)</translation>
    </message>
    <message>
        <source>Effort (hold)</source>
        <translation>Kraft (halten)</translation>
    </message>
    <message>
        <source>What a press sets</source>
        <translation>Was ein Druck vorgibt</translation>
    </message>
    <message>
        <source>Depth: the same depth everywhere, and a stiff place pushes back harder.
Effort: the same force everywhere, and a stiff place gives way less. The force rises by 1 N a second while the button is held; a pen gives it by its pressure. (E)</source>
        <translation>Tiefe: überall gleich tief, und eine steife Stelle drückt stärker zurück.
Kraft: überall gleich stark, und eine steife Stelle gibt weniger nach. Die Kraft wächst um 1 N je Sekunde, solange die Taste gehalten wird; ein Stift gibt sie durch seinen Druck vor. (E)</translation>
    </message>
    <message>
        <source>A press sets</source>
        <translation>Ein Druck gibt vor</translation>
    </message>
    <message>
        <source> N</source>
        <translation> N</translation>
    </message>
    <message>
        <source>Greatest effort</source>
        <translation>Größte Kraft</translation>
    </message>
    <message>
        <source>The press gets no harder than this, and a pen&apos;s full pressure is this; the wheel changes it by 0.5 N</source>
        <translation>Stärker wird der Druck nicht, und der volle Druck eines Stifts ist so stark; das Rad ändert es um 0,5 N</translation>
    </message>
    <message>
        <source>At most</source>
        <translation>Höchstens</translation>
    </message>
</context>
<context>
    <name>palpate::ui::HintLine</name>
    <message>
        <source>The newest message; F4 shows all</source>
        <translation>Die neueste Meldung; F4 zeigt alle</translation>
    </message>
    <message>
        <source>%1
Press here or F4 for all messages</source>
        <translation>%1
Hier drücken oder F4 für alle Meldungen</translation>
    </message>
    <message>
        <source>No new message</source>
        <translation>Keine neue Meldung</translation>
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
        <source>Law</source>
        <translation>Gesetz</translation>
    </message>
    <message>
        <source>By what law the force rises with the depth</source>
        <translation>Nach welchem Gesetz die Kraft mit der Tiefe steigt</translation>
    </message>
    <message>
        <source>Take the points of a measured curve from a CSV file with depth_mm and force_N</source>
        <translation>Die Punkte einer gemessenen Kurve aus einer CSV-Datei mit depth_mm und force_N nehmen</translation>
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
</context>
<context>
    <name>palpate::ui::LawPlot</name>
    <message>
        <source>Force in newton by depth in millimetres</source>
        <translation>Kraft in Newton über der Tiefe in Millimetern</translation>
    </message>
    <message>
        <source>Force [N] by depth [mm]. Drag a point; or choose one with ← → and move it with ↑ ↓</source>
        <translation>Kraft [N] über der Tiefe [mm]. Einen Punkt ziehen; oder mit ← → wählen und mit ↑ ↓ bewegen</translation>
    </message>
    <message>
        <source>Force [N] by depth [mm]</source>
        <translation>Kraft [N] über der Tiefe [mm]</translation>
    </message>
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
</context>
<context>
    <name>palpate::ui::LiveTouch</name>
    <message>
        <source> Its makers state no more.</source>
        <translation> Mehr geben seine Hersteller nicht an.</translation>
    </message>
    <message>
        <source> beside the layers around it</source>
        <translation> neben den Schichten ringsum</translation>
    </message>
    <message>
        <source>%1 can show tissue up to %2 N/mm.</source>
        <translation>%1 kann Gewebe bis %2 N/mm darstellen.</translation>
    </message>
    <message>
        <source>%1 can show tissue up to %2 N/mm here.</source>
        <translation>%1 kann hier Gewebe bis %2 N/mm darstellen.</translation>
    </message>
    <message>
        <source> Its force comes %1 ms late: anything stiffer could make it tremble.</source>
        <translation> Seine Kraft kommt %1 ms zu spät: bei Steiferem könnte es zittern.</translation>
    </message>
    <message>
        <source> A millimetre of the device is %1 mm of the scene: with a smaller scale (panel Device) it can show more.</source>
        <translation> Ein Millimeter des Geräts ist %1 mm der Szene: mit einem kleineren Maßstab (Panel „Gerät“) kann es mehr darstellen.</translation>
    </message>
    <message>
        <source>%1 asks for %2 N/mm; %3 N/mm is felt, the most that %4 can show here%5.</source>
        <translation>%1 verlangt %2 N/mm; gefühlt werden %3 N/mm, das meiste, was %4 hier darstellen kann%5.</translation>
    </message>
</context>
<context>
    <name>palpate::ui::Looks</name>
    <message>
        <source>As the system</source>
        <translation>Wie das System</translation>
    </message>
    <message>
        <source>Light or dark, as the system is</source>
        <translation>Hell oder dunkel, wie das System ist</translation>
    </message>
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
        <source>White text on black, with edges that are seen</source>
        <translation>Weiße Schrift auf Schwarz, mit sichtbaren Kanten</translation>
    </message>
    <message>
        <source>High contrast, on white</source>
        <translation>Hoher Kontrast, auf Weiß</translation>
    </message>
    <message>
        <source>Black text on white, with edges that are seen</source>
        <translation>Schwarze Schrift auf Weiß, mit sichtbaren Kanten</translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation>%1 %</translation>
    </message>
    <message>
        <source>Texts as large as the system&apos;s</source>
        <translation>Schrift so groß wie die des Systems</translation>
    </message>
    <message>
        <source>Texts in panels and in the view</source>
        <translation>Schrift in den Feldern und in der Ansicht</translation>
    </message>
</context>
<context>
    <name>palpate::ui::LumpMaps</name>
    <message>
        <source>No lump lies inside an organ here: nothing to be felt through one.</source>
        <translation>Hier liegt kein Knoten in einem Organ: nichts ist durch eines hindurch zu tasten.</translation>
    </message>
    <message>
        <source>Making what is felt through %1; until then a lump in it is felt as a layer</source>
        <translation>Was durch %1 hindurch gefühlt wird, wird berechnet; bis dahin ist ein Knoten darin eine Schicht</translation>
    </message>
    <message>
        <source>What can be felt of %1</source>
        <translation>Was an %1 tastbar ist</translation>
    </message>
    <message>
        <source>What is felt through an organ was cancelled: lumps are felt as layers until the scene changes.</source>
        <translation>Was durch ein Organ hindurch gefühlt wird, wurde abgebrochen: Knoten sind Schichten, bis sich die Szene ändert.</translation>
    </message>
    <message>
        <source>What can be felt here was cancelled.</source>
        <translation>Was hier tastbar ist, wurde abgebrochen.</translation>
    </message>
    <message>
        <source>How many times as stiff as %1 is %2? It is not known, so no verdict is given: type it in What can be felt (B), or choose one that is published.</source>
        <translation>Wievielmal so steif wie %1 ist %2? Das ist nicht bekannt, daher kein Urteil: in „Was tastbar ist“ (B) eingeben oder einen veröffentlichten Wert wählen.</translation>
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
        <source>friction, times the tissue&apos;s own</source>
        <translation>Reibung, Vielfaches der des Gewebes</translation>
    </message>
    <message>
        <source>stiffness felt, N/mm</source>
        <translation>Steifigkeit gefühlt, N/mm</translation>
    </message>
    <message>
        <source>stiffness felt, times the law</source>
        <translation>Steifigkeit gefühlt, Vielfaches des Gesetzes</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>nothing said</source>
        <translation>keine Angabe</translation>
    </message>
    <message>
        <source>%1: nothing said</source>
        <translation>%1: keine Angabe</translation>
    </message>
    <message>
        <source>resists fast movement, N·s/mm</source>
        <translation>bremst schnelle Bewegung, N·s/mm</translation>
    </message>
</context>
<context>
    <name>palpate::ui::MapEditor</name>
    <message>
        <source>Map</source>
        <translation>Karte</translation>
    </message>
    <message>
        <source>How the tissue varies over the surface</source>
        <translation>Wie das Gewebe über die Oberfläche variiert</translation>
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
        <source>By hand</source>
        <translation>Von Hand</translation>
    </message>
    <message>
        <source>The arrays of the mesh whose names say what they are, such as StiffnessScale</source>
        <translation>Die Felder des Netzes, deren Namen sagen, was sie sind, wie StiffnessScale</translation>
    </message>
    <message>
        <source>Varies</source>
        <translation>Variiert</translation>
    </message>
    <message>
        <source>What of the tissue varies</source>
        <translation>Was am Gewebe variiert</translation>
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
        <source>By</source>
        <translation>Nach</translation>
    </message>
    <message>
        <source>Which array of the mesh, or which volume, says it</source>
        <translation>Welches Feld des Netzes oder welches Volumen es sagt</translation>
    </message>
    <message>
        <source>In</source>
        <translation>In</translation>
    </message>
    <message>
        <source>What the numbers are. Shear and Young&apos;s modulus differ by a factor of three: see what the scanner&apos;s manual says</source>
        <translation>Was die Zahlen sind. Schub- und Elastizitätsmodul unterscheiden sich um den Faktor drei: siehe das Handbuch des Scanners</translation>
    </message>
    <message>
        <source>say which…</source>
        <translation>bitte angeben…</translation>
    </message>
    <message>
        <source>Times the tissue&apos;s own</source>
        <translation>Vielfaches des Gewebewerts</translation>
    </message>
    <message>
        <source>N/mm, as felt</source>
        <translation>N/mm, wie gefühlt</translation>
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
        <source>Of the finger that feels a modulus: the stiffness is 8 times radius times shear modulus</source>
        <translation>Des Fingers, der einen Modul fühlt: die Steifigkeit ist 8-mal Radius mal Schubmodul</translation>
    </message>
    <message>
        <source>Contact radius</source>
        <translation>Kontaktradius</translation>
    </message>
    <message>
        <source>Keep numbers within</source>
        <translation>Zahlen begrenzen</translation>
    </message>
    <message>
        <source>Numbers beyond are taken as the nearest one within</source>
        <translation>Zahlen außerhalb gelten als die nächste innerhalb</translation>
    </message>
    <message>
        <source>At least</source>
        <translation>Mindestens</translation>
    </message>
    <message>
        <source>At most</source>
        <translation>Höchstens</translation>
    </message>
    <message>
        <source>to</source>
        <translation>bis</translation>
    </message>
    <message>
        <source>What the map says</source>
        <translation>Was die Karte sagt</translation>
    </message>
    <message>
        <source>Show</source>
        <translation>Zeigen</translation>
    </message>
    <message>
        <source>Colours the structure by numbers, with a legend</source>
        <translation>Färbt die Struktur nach Zahlen, mit Legende</translation>
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
        <source>Say what the numbers of %1 are: shear and Young&apos;s modulus differ by a factor of three.</source>
        <translation>Geben Sie an, was die Zahlen von %1 sind: Schub- und Elastizitätsmodul unterscheiden sich um den Faktor drei.</translation>
    </message>
    <message>
        <source>%1 varies by %2.</source>
        <translation>%1 variiert nach %2.</translation>
    </message>
    <message>
        <source>%1: %2 of %3 places say nothing. The tissue&apos;s own is felt there.</source>
        <translation>%1: %2 von %3 Stellen haben keine Angabe. Dort wird der Wert des Gewebes gefühlt.</translation>
    </message>
    <message>
        <source>Resists fast movement</source>
        <translation>Bremst schnelle Bewegung</translation>
    </message>
</context>
<context>
    <name>palpate::ui::MapWarnings</name>
    <message>
        <source>(%1; %2; %3) mm</source>
        <translation>(%1; %2; %3) mm</translation>
    </message>
    <message>
        <source>%1: what the lumps below make of it changes too sharply for the %2 at %3.</source>
        <translation>%1: Was die Knoten darunter bewirken, ändert sich bei %3 zu scharf für das Gerät „%2“.</translation>
    </message>
    <message>
        <source>%1: its map of stiffness bends too sharply for the %2 at %3.</source>
        <translation>%1: Die Karte der Steifigkeit knickt bei %3 zu scharf für das Gerät „%2“.</translation>
    </message>
    <message>
        <source>The push aside jumps by %1 N there and can keep the hand swinging by %2 mm.</source>
        <translation>Die Kraft zur Seite springt dort um %1 N und kann die Hand um %2 mm schwingen lassen.</translation>
    </message>
    <message>
        <source>Give the tissue friction, or open a mesh with shorter edges there.</source>
        <translation>Dem Gewebe Reibung geben oder ein Netz öffnen, das dort kürzere Kanten hat.</translation>
    </message>
    <message>
        <source>Spread the step over more millimetres, round its ends, or give the tissue friction.</source>
        <translation>Die Stufe über mehr Millimeter verteilen, ihre Enden abrunden oder dem Gewebe Reibung geben.</translation>
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
        <source>1 older message waits (F4 shows all)</source>
        <translation>1 ältere Meldung wartet (F4 zeigt alle)</translation>
    </message>
    <message>
        <source>%1 older messages wait (F4 shows all)</source>
        <translation>%1 ältere Meldungen warten (F4 zeigt alle)</translation>
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
        <source>Close this message; the list of messages keeps it (F4)</source>
        <translation>Diese Meldung schließen; die Liste der Meldungen behält sie (F4)</translation>
    </message>
    <message>
        <source>Close this message</source>
        <translation>Diese Meldung schließen</translation>
    </message>
</context>
<context>
    <name>palpate::ui::Messages</name>
    <message>
        <source>%1: %2</source>
        <translation>%1: %2</translation>
    </message>
    <message>
        <source>Told</source>
        <translation>Mitteilung</translation>
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
</context>
<context>
    <name>palpate::ui::PalpationController</name>
    <message>
        <source>%1 mm is the deepest press: the scene is no larger.</source>
        <translation>%1 mm ist der tiefste Druck: größer ist die Szene nicht.</translation>
    </message>
    <message>
        <source>Nothing that can be felt is in view.</source>
        <translation>In der Ansicht ist nichts, was sich fühlen lässt.</translation>
    </message>
    <message>
        <source>camera</source>
        <translation>Kamera</translation>
    </message>
    <message>
        <source>presses %1 mm</source>
        <translation>drückt %1 mm</translation>
    </message>
    <message>
        <source>pressing %1 mm, slid off the edge</source>
        <translation>drückt %1 mm, vom Rand geglitten</translation>
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
        <source>%1 N is the hardest press.</source>
        <translation>%1 N ist der stärkste Druck.</translation>
    </message>
    <message>
        <source>presses up to %1 N</source>
        <translation>drückt bis %1 N</translation>
    </message>
    <message>
        <source>aims at %1 of %2 N, reaches %3 N, %4 mm</source>
        <translation>Ziel %1 von %2 N, erreicht %3 N, %4 mm</translation>
    </message>
</context>
<context>
    <name>palpate::ui::Playback</name>
    <message>
        <source>structure %1</source>
        <translation>Struktur %1</translation>
    </message>
</context>
<context>
    <name>palpate::ui::RecordedTouch</name>
    <message>
        <source>%1 ended at %2 s because the disk was full; what was felt after is not in it.</source>
        <translation>%1 endete bei %2 s, weil der Datenträger voll war; was danach gefühlt wurde, fehlt darin.</translation>
    </message>
    <message>
        <source>%1 ended at %2 s because the disk could not be written; what was felt after is not in it.</source>
        <translation>%1 endete bei %2 s, weil der Datenträger nicht beschreibbar war; was danach gefühlt wurde, fehlt darin.</translation>
    </message>
    <message>
        <source>%1 was not closed (a crash, or a full disk): it ends at %2 s, and what was felt after is not in it.</source>
        <translation>%1 wurde nicht abgeschlossen (Absturz oder voller Datenträger): sie endet bei %2 s, und was danach gefühlt wurde, fehlt darin.</translation>
    </message>
    <message>
        <source>%1: %2 moments were lost while it was recorded, because the disk was too slow.</source>
        <translation>%1: %2 Augenblicke gingen bei der Aufzeichnung verloren, weil der Datenträger zu langsam war.</translation>
    </message>
    <message numerus="yes">
        <source>%1 is damaged, or was changed after it was recorded: %n place(s) do not match their checksums. What was felt there is left out; &quot;palpate session verify&quot; names the first place.</source>
        <translation>
            <numerusform>%1 ist beschädigt oder wurde nach der Aufnahme geändert: %n Stelle passt nicht zu ihrer Prüfsumme. Was dort gefühlt wurde, fehlt; „palpate session verify“ nennt die erste Stelle.</numerusform>
            <numerusform>%1 ist beschädigt oder wurde nach der Aufnahme geändert: %n Stellen passen nicht zu ihren Prüfsummen. Was dort gefühlt wurde, fehlt; „palpate session verify“ nennt die erste Stelle.</numerusform>
        </translation>
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
        <source>its view</source>
        <translation>ihre Ansicht</translation>
    </message>
    <message>
        <source>the fields of it that this version does not know</source>
        <translation>ihre Felder, die diese Version nicht kennt</translation>
    </message>
    <message>
        <source>%1: opened together with another scene; not taken: %2</source>
        <translation>%1: zusammen mit einer anderen Szene geöffnet; nicht übernommen: %2</translation>
    </message>
    <message>
        <source>, </source>
        <translation>, </translation>
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
        <source>Speed of playing; 1 × is as it was recorded</source>
        <translation>Tempo des Abspielens; 1 × ist wie aufgezeichnet</translation>
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
        <source>List only what has these words in its name (Ctrl+F); Esc lists all</source>
        <translation>Nur auflisten, was diese Wörter im Namen hat (Strg+F); Esc listet alle auf</translation>
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
        <source>By layer, as felt</source>
        <translation>Nach Schicht, wie gefühlt</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 von %2</translation>
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
        <source>%1 below</source>
        <translation>%1 darunter</translation>
    </message>
    <message>
        <source>%1 is shown. Click to hide it; what is hidden is not felt.</source>
        <translation>%1 wird gezeigt. Zum Verbergen klicken; Verborgenes wird nicht gefühlt.</translation>
    </message>
    <message>
        <source>%1 is hidden. Click to show it.</source>
        <translation>%1 ist verborgen. Zum Zeigen klicken.</translation>
    </message>
    <message>
        <source>%1, felt %2</source>
        <translation>%1, gefühlt %2</translation>
    </message>
    <message>
        <source>%1
%2 triangles
Felt: %3</source>
        <translation>%1
%2 Dreiecke
Gefühlt: %3</translation>
    </message>
    <message>
        <source>%1 can be felt. Click to let the hand pass through it.</source>
        <translation>%1 ist zu fühlen. Klicken, um die Hand hindurchzulassen.</translation>
    </message>
    <message>
        <source>The hand passes through %1. Click to feel it.</source>
        <translation>Die Hand geht durch %1 hindurch. Zum Fühlen klicken.</translation>
    </message>
    <message>
        <source>Structure</source>
        <translation>Struktur</translation>
    </message>
    <message>
        <source>Shown</source>
        <translation>Gezeigt</translation>
    </message>
    <message>
        <source>Name and colour</source>
        <translation>Name und Farbe</translation>
    </message>
    <message>
        <source>What was found in the mesh</source>
        <translation>Was im Netz gefunden wurde</translation>
    </message>
    <message>
        <source>Can be felt</source>
        <translation>Zu fühlen</translation>
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
        <source>The mesh is inside out: felt from within only</source>
        <translation>Das Netz ist umgestülpt: nur von innen zu fühlen</translation>
    </message>
    <message>
        <source>The mesh had faults, which were mended</source>
        <translation>Das Netz hatte Fehler; sie wurden behoben</translation>
    </message>
    <message>
        <source>The mesh branches along some edges</source>
        <translation>Das Netz verzweigt sich an manchen Kanten</translation>
    </message>
    <message>
        <source>About the mesh of %1:
• %2
The list of messages (F4) has the details.</source>
        <translation>Zum Netz von %1:
• %2
Einzelheiten stehen in der Liste der Meldungen (F4).</translation>
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
        <source>The surface is a staircase of %1 × %2 × %3 mm voxels: the hand feels its steps</source>
        <translation>Die Oberfläche ist eine Treppe aus Voxeln von %1 × %2 × %3 mm: Die Hand spürt ihre Stufen</translation>
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
        <source>Opacity [%]: what lies behind shows through</source>
        <translation>Deckkraft [%]: was dahinter liegt, scheint durch</translation>
    </message>
    <message>
        <source>Opacity</source>
        <translation>Deckkraft</translation>
    </message>
    <message>
        <source>%1 as felt [%2]: %3</source>
        <translation>%1, wie gefühlt [%2]: %3</translation>
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
        <source>How the structure feels, by name</source>
        <translation>Wie sich die Struktur anfühlt, nach Namen</translation>
    </message>
    <message>
        <source>Friction</source>
        <translation>Reibung</translation>
    </message>
    <message>
        <source>How much the surface holds the fingertip, by name</source>
        <translation>Wie stark die Oberfläche die Fingerspitze hält, nach Namen</translation>
    </message>
    <message>
        <source>What is felt of it</source>
        <translation>Was davon gefühlt wird</translation>
    </message>
    <message>
        <source>Why the value was refused</source>
        <translation>Warum der Wert abgewiesen wurde</translation>
    </message>
    <message>
        <source>Felt, in order from outside</source>
        <translation>Gefühlt, der Reihe nach von außen</translation>
    </message>
    <message>
        <source>What a hand meets first as it presses in, and what it meets through that (Ctrl+Down, Ctrl+Up in the list)</source>
        <translation>Worauf eine Hand beim Eindrücken zuerst trifft, und worauf durch dieses hindurch (Strg+↓, Strg+↑ in der Liste)</translation>
    </message>
    <message>
        <source>Felt</source>
        <translation>Gefühlt</translation>
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
        <source>%1 takes %2</source>
        <translation>%1 nimmt %2</translation>
    </message>
    <message>
        <source>This law is refused: %1.</source>
        <translation>Dieses Gesetz wird abgewiesen: %1.</translation>
    </message>
    <message>
        <source>%1 Of that %2.</source>
        <translation>%1 Davon: %2.</translation>
    </message>
    <message>
        <source>%1 N/mm is refused. %2 Enter %3 N/mm or less.</source>
        <translation>%1 N/mm wird abgewiesen. %2 Geben Sie %3 N/mm oder weniger ein.</translation>
    </message>
    <message>
        <source>A law that rises by %1 N/mm where it is steepest is refused. %2 Enter numbers by which it rises by %3 N/mm or less.</source>
        <translation>Ein Gesetz, das an der steilsten Stelle um %1 N/mm steigt, wird abgewiesen. %2 Geben Sie Zahlen ein, mit denen es um höchstens %3 N/mm steigt.</translation>
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
        <source>Feel all</source>
        <translation>Alle fühlen</translation>
    </message>
    <message>
        <source>numbers chosen</source>
        <translation>Zahlen gewählt</translation>
    </message>
    <message>
        <source>shear modulus by MR elastography (PMC2894569), as a fingertip of 5 mm radius feels it</source>
        <translation>Schubmodul aus MR-Elastographie (PMC2894569), wie eine Fingerspitze von 5 mm Radius ihn fühlt</translation>
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
        <source>shape after Carter et al. 2001 (exponential), numbers chosen</source>
        <translation>Form nach Carter et al. 2001 (exponentiell), Zahlen gewählt</translation>
    </message>
    <message>
        <source>Soft ground under a ball</source>
        <translation>Weicher Grund unter einer Kugel</translation>
    </message>
    <message>
        <source>shape after Hertz 1882, numbers chosen</source>
        <translation>Form nach Hertz 1882, Zahlen gewählt</translation>
    </message>
    <message>
        <source>Button that clicks</source>
        <translation>Knopf, der klickt</translation>
    </message>
    <message>
        <source>None</source>
        <translation>Keine</translation>
    </message>
    <message>
        <source>Wet (0.05, chosen)</source>
        <translation>Nass (0,05, gewählt)</translation>
    </message>
    <message>
        <source>Moist (0.15, chosen)</source>
        <translation>Feucht (0,15, gewählt)</translation>
    </message>
    <message>
        <source>Dry (0.40, chosen)</source>
        <translation>Trocken (0,40, gewählt)</translation>
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
        <source>Show only what is selected</source>
        <translation>Nur die Auswahl zeigen</translation>
    </message>
    <message>
        <source>Feel only what is selected</source>
        <translation>Nur die Auswahl fühlen</translation>
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
        <source>The list of messages (F4) has the details</source>
        <translation>Einzelheiten stehen in der Liste der Meldungen (F4)</translation>
    </message>
    <message>
        <source>felt as at most %1 N/mm: the device can show %2 N/mm in all%3</source>
        <translation>gefühlt als höchstens %1 N/mm: das Gerät kann insgesamt %2 N/mm darstellen%3</translation>
    </message>
    <message>
        <source>felt as %1 N/mm: the device can show %2 N/mm in all%3</source>
        <translation>gefühlt als %1 N/mm: das Gerät kann insgesamt %2 N/mm darstellen%3</translation>
    </message>
    <message>
        <source>%1 N·s/mm is refused: the device can resist movement with %2 N·s/mm at most. Enter that or less.</source>
        <translation>%1 N·s/mm wird abgewiesen: das Gerät kann Bewegung mit höchstens %2 N·s/mm bremsen. Geben Sie dies oder weniger ein.</translation>
    </message>
    <message>
        <source>Change %1</source>
        <translation>%1 ändern</translation>
    </message>
    <message>
        <source>on its own surface, outermost</source>
        <translation>auf eigener Oberfläche, außen</translation>
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
        <source>What its map can do to the device</source>
        <translation>Was die Karte mit dem Gerät machen kann</translation>
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
        <source>Smoothing takes away the steps of voxels, by at most half a voxel, for the eye and for the hand. The file is not changed.</source>
        <translation>Glätten entfernt die Stufen der Voxel, um höchstens ein halbes Voxel, für Auge und Hand. Die Datei wird nicht verändert.</translation>
    </message>
    <message>
        <source>Turn around</source>
        <translation>Umdrehen</translation>
    </message>
    <message>
        <source>Young&apos;s modulus by shear-wave ultrasound (Arda et al. 2011, AJR 197:532), as a fingertip of 5 mm radius feels it</source>
        <translation>Young-Modul durch Scherwellen-Ultraschall (Arda et al. 2011, AJR 197:532), wie eine Fingerkuppe von 5 mm Radius ihn fühlt</translation>
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
        <source>Young&apos;s modulus by indentation (Urology 2010), as a fingertip of 5 mm radius feels it</source>
        <translation>Young-Modul durch Eindrücken (Urology 2010), wie eine Fingerkuppe von 5 mm Radius ihn fühlt</translation>
    </message>
    <message>
        <source>Breast (3.2 kPa)</source>
        <translation>Brust (3,2 kPa)</translation>
    </message>
    <message>
        <source>Young&apos;s modulus by indentation (Teixeira et al. 2023), as a fingertip of 5 mm radius feels it</source>
        <translation>Young-Modul durch Eindrücken (Teixeira et al. 2023), wie eine Fingerkuppe von 5 mm Radius ihn fühlt</translation>
    </message>
    <message>
        <source>Lymph node</source>
        <translation>Lymphknoten</translation>
    </message>
    <message>
        <source>number chosen below 22 kPa, above which lymph nodes count as malignant (2.71 m/s by shear-wave ultrasound)</source>
        <translation>Wert gewählt unter 22 kPa, ab denen Lymphknoten als bösartig gelten (2,71 m/s durch Scherwellen-Ultraschall)</translation>
    </message>
</context>
<context>
    <name>palpate::ui::StructureTree</name>
    <message>
        <source>Felt outermost</source>
        <translation>Zuäußerst gefühlt</translation>
    </message>
    <message>
        <source>Felt %1 below</source>
        <translation>%1 darunter gefühlt</translation>
    </message>
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
        <source>Feel all of %1</source>
        <translation>Alle aus %1 fühlen</translation>
    </message>
</context>
<context>
    <name>palpate::ui::Terms</name>
    <message>
        <source>Stiffness</source>
        <translation>Steifigkeit</translation>
    </message>
    <message>
        <source>force for each mm pressed in</source>
        <translation>Kraft je eingedrücktem mm</translation>
    </message>
    <message>
        <source>newton per millimetre</source>
        <translation>Newton je Millimeter</translation>
    </message>
    <message>
        <source>force against each mm/s of movement</source>
        <translation>Kraft gegen jeden mm/s der Bewegung</translation>
    </message>
    <message>
        <source>newton seconds per millimetre</source>
        <translation>Newtonsekunden je Millimeter</translation>
    </message>
    <message>
        <source>Friction at rest</source>
        <translation>Haftreibung</translation>
    </message>
    <message>
        <source>share of the normal force that holds</source>
        <translation>Anteil der Normalkraft, der hält</translation>
    </message>
    <message>
        <source>Friction sliding</source>
        <translation>Gleitreibung</translation>
    </message>
    <message>
        <source>share of the normal force that drags while it slides</source>
        <translation>Anteil der Normalkraft, der beim Gleiten bremst</translation>
    </message>
    <message>
        <source>Drag</source>
        <translation>Viskose Reibung</translation>
    </message>
    <message>
        <source>force against each mm/s of sliding</source>
        <translation>Kraft gegen jeden mm/s des Gleitens</translation>
    </message>
    <message>
        <source>Stiffness at first touch</source>
        <translation>Steifigkeit bei erster Berührung</translation>
    </message>
    <message>
        <source>Growth with depth</source>
        <translation>Zunahme mit der Tiefe</translation>
    </message>
    <message>
        <source>Greatest stiffness</source>
        <translation>Größte Steifigkeit</translation>
    </message>
    <message>
        <source>Young&apos;s modulus</source>
        <translation>Elastizitätsmodul</translation>
    </message>
    <message>
        <source>Radius of the ball</source>
        <translation>Radius der Kugel</translation>
    </message>
    <message>
        <source>Thickness of the layer</source>
        <translation>Dicke der Schicht</translation>
    </message>
    <message>
        <source>Bonded to what is below</source>
        <translation>Mit dem darunter verbunden</translation>
    </message>
    <message>
        <source>Stiffness before the click</source>
        <translation>Steifigkeit vor dem Klick</translation>
    </message>
    <message>
        <source>Force at which it gives way</source>
        <translation>Kraft, bei der es nachgibt</translation>
    </message>
    <message>
        <source>Force that it falls to</source>
        <translation>Kraft, auf die es fällt</translation>
    </message>
    <message>
        <source>Depth over which it falls</source>
        <translation>Tiefe, über die es fällt</translation>
    </message>
    <message>
        <source>Stiffness after the click</source>
        <translation>Steifigkeit nach dem Klick</translation>
    </message>
    <message>
        <source>Resists fast movement</source>
        <translation>Bremst schnelle Bewegung</translation>
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
        <source>nothing was felt yet</source>
        <translation>noch nichts gefühlt</translation>
    </message>
    <message>
        <source>now %1 N, %2 mm deep; at most %3 N, %4 mm</source>
        <translation>jetzt %1 N, %2 mm tief; höchstens %3 N, %4 mm</translation>
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
        <source>Force in newton</source>
        <translation>Kraft in Newton</translation>
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
        <source>Touched structures, the outermost first, with their forces and depths</source>
        <translation>Berührte Strukturen, die äußerste zuerst, mit Kräften und Tiefen</translation>
    </message>
    <message>
        <source>Depth and stiffness</source>
        <translation>Tiefe und Steifigkeit</translation>
    </message>
    <message>
        <source>Depth: from the outermost surface to the hand [mm]; stiffness as felt, of all layers that are touched [N/mm]</source>
        <translation>Tiefe: von der äußersten Oberfläche zur Hand [mm]; Steifigkeit, wie gefühlt, aller berührten Schichten [N/mm]</translation>
    </message>
    <message>
        <source>press on a structure to feel it</source>
        <translation>auf eine Struktur drücken, um sie zu fühlen</translation>
    </message>
    <message>
        <source>%1 mm deep · slid off the edge</source>
        <translation>%1 mm tief · vom Rand geglitten</translation>
    </message>
    <message>
        <source>slid off the edge</source>
        <translation>vom Rand geglitten</translation>
    </message>
    <message>
        <source>%1 N, %2 mm deep</source>
        <translation>%1 N, %2 mm tief</translation>
    </message>
    <message>
        <source>More triangles of the mesh lie in this place than there is time to feel at once</source>
        <translation>An dieser Stelle hat das Netz mehr Dreiecke, als sich auf einmal fühlen lassen</translation>
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
        <source>very fine mesh here: the force follows late</source>
        <translation>hier ist das Netz sehr fein: die Kraft folgt verspätet</translation>
    </message>
    <message>
        <source>%1 in %2</source>
        <translation>%1 in %2</translation>
    </message>
    <message>
        <source>Each layer that is touched, the outermost first: its part along the force [N], which add
up to it, and how deep the hand is in it [mm]</source>
        <translation>Jede berührte Schicht, die äußerste zuerst: ihr Anteil längs der Kraft [N], die sich
zu ihr addieren, und wie tief die Hand darin ist [mm]</translation>
    </message>
    <message>
        <source>over %1: %2, %3</source>
        <translation>über %1: %2, %3</translation>
    </message>
    <message>
        <source>over %1: %2</source>
        <translation>über %1: %2</translation>
    </message>
</context>
<context>
    <name>palpate::ui::TouchSound</name>
    <message>
        <source>no loudspeaker is there</source>
        <translation>kein Lautsprecher da</translation>
    </message>
    <message>
        <source>%1 can&apos;t play it</source>
        <translation>%1 kann ihn nicht spielen</translation>
    </message>
    <message>
        <source>built without Qt Multimedia</source>
        <translation>ohne Qt Multimedia gebaut</translation>
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
        <source>turn the camera by 15°; with Shift: move it</source>
        <translation>die Kamera um 15° drehen; mit Umschalt: verschieben</translation>
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
        <source>move the place to press by 2 mm along the screen</source>
        <translation>die Druckstelle um 2 mm entlang des Bildschirms verschieben</translation>
    </message>
    <message>
        <source>Enter</source>
        <translation>Enter</translation>
    </message>
    <message>
        <source>press there, let go</source>
        <translation>dort drücken, loslassen</translation>
    </message>
    <message>
        <source>Page down  up</source>
        <translation>Bild ab  auf</translation>
    </message>
    <message>
        <source>press deeper, less deep by 0.5 mm</source>
        <translation>um 0,5 mm tiefer, weniger tief drücken</translation>
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
        <source>Open the phantom that comes with Palpate: a liver with two lumps, and a recorded palpation</source>
        <translation>Das mit Palpate gelieferte Phantom öffnen: eine Leber mit zwei Knoten und eine aufgezeichnete Palpation</translation>
    </message>
    <message>
        <source>Then press P, drag to press, and set the depth with the wheel. Press ? for all keys.</source>
        <translation>Dann P drücken, zum Drücken ziehen und die Tiefe mit dem Rad stellen. ? zeigt alle Tasten.</translation>
    </message>
    <message>
        <source>or</source>
        <translation>oder</translation>
    </message>
</context>
</TS>
