<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="fr" sourcelanguage="en">
<context>
    <name>CoordinatesChoice</name>
    <message>
        <source>RAS</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Y up</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>LPS</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Coordinates: LPS</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The files count to the patient&apos;s left, back and head, as DICOM does</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Coordinates: RAS</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The files count to the patient&apos;s right, front and head, as older models of 3D Slicer do</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Coordinates: Y up</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The files count to the patient&apos;s left, head and front, as modelling programs do</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source> and </source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 assumed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The files&apos; coordinates are %1.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Not every file says along which axes it lies: %1 is assumed, and left and right may be exchanged. Click to say it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The surfaces are a recording&apos;s and stay as they were felt.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Coordinates: %1</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>FeltLayers</name>
    <message>
        <source>%1 N, %2 mm in</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 N</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>holds %1 N</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>slides %1 N</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>FindingType</name>
    <message>
        <source>lump</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>hard area</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>soft area</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>landmark</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>keep away</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>other</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>FindingsDesk</name>
    <message>
        <source>Nothing is touched: press on the place first, then mark it (M).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Finding %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 marked: %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 marked on %2 with %3 N</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Note %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No finding yet: press on a place and mark it (M).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 keeps no view.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 was not marked in a recording.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A recording is being made: stop it (R) to play.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: the recording of %2 is not there any more.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: this is another recording than the one in which %2 was marked.</source>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>%n finding(s) written to %1</source>
        <translation type="unfinished">
            <numerusform></numerusform>
            <numerusform></numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Import %n finding(s)</source>
        <translation type="unfinished">
            <numerusform></numerusform>
            <numerusform></numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n finding(s) taken from %1</source>
        <translation type="unfinished">
            <numerusform></numerusform>
            <numerusform></numerusform>
        </translation>
    </message>
</context>
<context>
    <name>MainWindow</name>
    <message>
        <source>Palpate</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Structures</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Touch</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Device</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Session</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Progress of opening</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stop opening; what was open stays</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Research, training and planning rehearsal. Not a medical device.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Undo</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Undo: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Redo</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Redo: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Opening was cancelled.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Reading what varies over %1…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The map of %1 is felt.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open meshes, a scene or a recording</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save scene</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save the scene with its tissue</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save scene as…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save the scene with its tissue to another file</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Snapshot</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save a picture of the view</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Quit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>End Palpate</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Undo the newest change</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Do it again</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Fit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Fit everything into the view</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Findings</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show the places marked as findings</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>From the front (A)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>From the back (P)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>From the left (L)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>From the right (R)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>From the head (S)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>From the feet (I)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Oblique</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>hold Space</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>palpate while it is held</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>drag</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>camera: rotate · palpate: press and slide</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>right drag</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>camera: zoom · palpate: rotate</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>middle drag</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>pan</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>wheel</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>camera: zoom · palpate: depth in mm (with Ctrl: zoom)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>double-click</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>centre the view on the point</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Let go</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>let go, then back to the camera</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>show or hide, feel or not</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ctrl+↓  ↑</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>felt a layer deeper, farther out</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Palpate with the pointer: drag to press, wheel for the depth; off: the pointer moves the camera</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Clutch</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Move the device without the hand in the scene; again to let go</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Record</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Record what the hand feels, every tick</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Play</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Play or pause the recording</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>To the start</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Back to the recording&apos;s start</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Mark a finding</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Mark the place that is touched, in the scene and in the recording</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Note…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Results…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Forces, coverage and findings of the recording, and exports</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Keep the surfaces inside recordings</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>One file then holds the whole session; it grows by what the meshes take</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Fit all to the device</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>All that is shown fills the device&apos;s workspace</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Fit organ to the device</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The organ that is touched or pointed at fills the device&apos;s workspace</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Fit lump to the device</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>10 mm about what is touched, pointed at or found fill the device&apos;s workspace</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>All keys</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show all keys</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;File</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open recent</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Edit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;View</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Session</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Help</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Tools</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Recording</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Servo rate</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Real-time scheduling</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 kHz</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ticks of the servo thread a second [kHz], over the last half second</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>real-time</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>not real-time</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What the servo thread was granted:</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Pause</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stop</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Device</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>P palpate, drag to press, wheel for depth</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Touch with the device; O or L fits the organ or lump to it, C clutches</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Feel again</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>This anatomy is %1 mm across: its numbers are probably metres.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Read as metres</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>1 note on these files</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 notes on these files</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 can be played, but the meshes that it was made on are not where they were. Open them to see what was touched.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Palpate scene (*.palpate.json)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Scene saved to %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Unsaved changes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save the changes to this scene?</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Unsaved scene</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1[*] – Palpate</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Palpate ended unexpectedly and left unsaved changes of a scene.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Restore</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open anatomy</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Anatomy, scenes and recordings (%1);;All files (*)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1; %2 more of that kind: Felt in the panel has each.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Feel what is inside below what is around it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>All in one layer</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Feel all in one layer</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 lies in %2, but this scene has all in one layer: it is not felt through %2.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Feel it below</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Recorded to %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Recording %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Picture saved to %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: the picture could not be written. Is the folder writable and the disk not full?</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Palpate[*]</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Findings and measures</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open what was recorded</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Add to the scene…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open more meshes or a scene beside what is open</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Close the scene</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Close what is open</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Import findings…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Take the points of a 3D Slicer markups file (.mrk.json) as findings</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Export findings…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Write findings and notes as a table (CSV) or as 3D Slicer markups (.mrk.json)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Find a structure…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>List only structures with these words in their names</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rename the structure…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Write another name for the selected structure</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Remove from the scene</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Take the selected structures out of the scene; their files stay</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>click</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>camera: select the structure (with Ctrl: one more)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ctrl+E  Ctrl+H</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>letters</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>go to the structure that begins so</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>F2  Del</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>rename, remove from the scene</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Enter  F2  Del</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>in the findings: go there, edit, delete</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Shift+Enter</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>in the findings: play where it was marked</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Mark a finding and write…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Mark the place that is touched and write about it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Write a note without a place</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Next finding</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Go to the next finding, in the view from which it was marked</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Previous finding</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Go to the finding before</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What the pointer or the device does</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What the pointer does: it turns the view, or it presses this far along the line of sight [mm]; the wheel sets it (P switches)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stop the recording first: it holds the surfaces as they lie now.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1  ·  %2 (F4 lists them)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Read again with coordinates %1: tissue and findings are kept, undo starts anew.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The scene was changed elsewhere</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 was saved by another window or program since it was opened here. To save it would replace what was saved there.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save anyway</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save as…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 and %2 more</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>These changes were already restored in another window.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 files</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Add %1 to the open scene?</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Add</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open instead</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>3D Slicer markups (*.mrk.json)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Table (*.csv)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Export findings</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Import findings</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>3D Slicer markups (*.mrk.json *.json);;All files (*)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Add to the scene</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Add %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Add %1 structures</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 was added to the scene.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 structures were added to the scene.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What was added lies in or around other structures, but the layers that were set are kept.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Tissue by names</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 got its tissue by its name.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 structures got tissue by their names.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Tissue as before</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Next panel</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The keys go to the next panel, and on to the view</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Previous panel</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The keys go to the panel before</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Hide or show all panels</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Messages</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show or hide the list of all messages since the start, with all notes on files</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Single-letter keys</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Commands by one letter; off: letters do nothing, for speech input and for hands that touch keys by chance</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Not real-time: %1: %2. %3</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Touching with the %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Turning the view</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>MeasuresDialog</name>
    <message>
        <source>Measuring…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>VTK poly data (*.vtp)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Data table (CSV)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Data table (*.csv)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Path and map for 3D Slicer</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Results (JSON)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Results (*.json)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Results of %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Results of the session</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What became of the newest export</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Progress of the export</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cancel the export</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Copy</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Copy all tables, to be pasted into a spreadsheet (Ctrl+C)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Every tick with its time, places, forces, depth and events</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The path of the hand, and beside it the touched surface with time spent and peak force</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The tables above, and more, for a program</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Copied: paste it into a spreadsheet.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Nothing was written: %1 is there already. Choose it by its whole name to replace it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Nothing was written: %1 ends in %2. A name for %3 ends in %4.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Written to %1.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Written to %1 and %2.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The path is written to %1; the map is not: %2</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>RecordingControl</name>
    <message>
        <source>Length of the recording [min:s]; ticks that were late, because the computer was busy: nothing was felt in them; ticks that were lost, because the disk was slow: they were felt and are not in it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Recording</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A recording is running. End it and close?</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What was felt until now is kept in %1.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>End the recording</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Go on recording</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>● recording %1, the disk does not answer</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>● recording %1, %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>recording failed at %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 ended by itself</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>ResultTables</name>
    <message>
        <source>Session</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Duration</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>In contact</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Contacts</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Path of the hand</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Path on the surface</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ticks late</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ticks lost</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 mm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>not said</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Touch</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Force and depth</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Time spent [s]</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Mean [N]</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Median [N]</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Nearly highest [N]</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Peak [N]</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Deepest [mm]</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Presses</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>All</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Search and press</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Hand</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Phases</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Searching</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Pressing</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Share of the surface that was examined: within %1, the fingertip&apos;s radius</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Share of the surface that was examined: within %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Surface</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Area [cm²]</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Examined [%]</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Longest time at one place [s]</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>its mesh is not there</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Findings</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Finding</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>On</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Marked</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>First touched</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Times returned</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>never</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Notes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Note</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Written</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Findings, layer by layer</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Felt when marked</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Structure</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Force [N]</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Depth [mm]</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Nearly highest: the force that 95 % of the contact stayed below. Research measures, not a diagnosis.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>SceneDocument</name>
    <message>
        <source>Mark %1</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>palpate::app::Fingertip</name>
    <message>
        <source>Fingertip</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ball of %1 mm radius</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Point</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>palpate::app::Help</name>
    <message>
        <source>Documents</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open the folder of documents: keys, recordings, measures, glossary, devices</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>About Palpate</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Version, build and licences, to copy for a report</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The documents were not found beside the program.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Nothing here opens folders; the documents are in %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Research, training and planning rehearsal. Not a medical device.

Palpate is free software under the BSD 3-Clause licence. It is made with Qt (LGPL 3), VTK (BSD 3-Clause), Eigen (MPL 2.0), SQLite (public domain), hidapi (BSD) and CLI11 (BSD 3-Clause).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Copy for a report</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Copied: version, build and system.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>palpate::app::Language</name>
    <message>
        <source>Language</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Palpate speaks another language when it is started again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>As the system</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>palpate::ui::ActionList</name>
    <message>
        <source>%1 (%2)</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>palpate::ui::ChipRow</name>
    <message>
        <source>What else there is to say</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What there is no room for in this row</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>palpate::ui::DeviceChoice</name>
    <message>
        <source>Mouse</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The pointer over the view; it feels nothing, the force is shown</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Simulated hand</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Palpates what is in the middle of the view, and feels the force</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Recording, felt anew</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The open recording&apos;s motion, felt with the tissue as it is now</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 (skipped)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>SpaceMouse moves the view</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The puck turns and shifts the anatomy while another device is the hand</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Calibrate</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Takes the pose that the device is in now as its calibration pose</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What is plugged in…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 lost</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: calibrate</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 %2 ms</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The hand&apos;s device: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>It feels nothing: the force is shown, up to %1 N.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Up to %1 N and %2 N/mm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>From report received to force written: %1 ms, 99 % below %2 ms, at most %3 ms</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 reports, %2 refused, lost %3 times</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: it would need %2.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No haptic device and no 6-axis mouse is plugged in.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Devices</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>palpate::ui::EnergyBar</name>
    <message>
        <source>Energy observer</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>palpate::ui::FindingsModel</name>
    <message>
        <source>%1: %2 N, %3 mm deep</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>felt %1 N/mm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Delete %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Delete %1 findings</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>note</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Number, as in the view</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>№</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Type</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Name</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The structure that was touched</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Where</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Size across, as you judge it [mm]</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Size</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Force when it was marked [N]</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>N</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Depth when it was marked [mm]</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>mm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Note</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Type of %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rename %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Size: found “%1”, expected millimetres as %2.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Size of %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Note on %1</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>palpate::ui::FindingsPanel</name>
    <message>
        <source>Findings and notes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No finding yet. Press on a place and mark it with M; N writes a note without a place.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Write a note (N), Enter keeps it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>New note without a place</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>palpate::ui::ForceBar</name>
    <message>
        <source>Force of the model [N]; the bar ends at the device&apos;s limit of %1 N</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>limit %1 N</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>palpate::ui::ForceTimeline</name>
    <message>
        <source>Timeline of the recording&apos;s force</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Force [N] over the recording. Click or drag to go there; ← and → step 0.1 s, Home and End.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The force of a recording appears here</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source> s</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 N</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 s: %2</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>palpate::ui::HandControl</name>
    <message>
        <source>%1; any is used</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Touch the place, point at it or mark it as a finding (M) first.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Nothing is shown that could fill the device&apos;s workspace.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 fills the workspace. The hand stays where it touches; Centre brings it to the middle.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 fills the workspace.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The whole scene</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>10 mm where the hand touches</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>10 mm under the pointer</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>10 mm about finding %1</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>palpate::ui::HandPanel</name>
    <message>
        <source>No motors: force is shown, not felt, and any stiffness is stable.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Holds up to %1 N/mm at %2 kHz with %3 ms of delay; more is refused.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>At the edge of the workspace: bring the device back to its middle. The hand in the scene stays until then.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Clutched: the device moves, the hand in the scene stays.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Inside %1, which is felt from outside: bring the hand out towards you first.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>As it lies: the device&apos;s millimetres are the scene&apos;s.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>1 mm of the device is %1 mm of the scene.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 fills the workspace: 1 mm of the device is %2 mm of the scene.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Nothing yet</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Latency %1 ms, 99 % below %2 ms</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Jitter 99.9 % below %1 µs</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 of %2 ticks late</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Force on the hand</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stiffness that is held</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Energy observer</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Energy observer: what the hand has put into the touched tissue and not got back [mJ].
Below zero the program would give more than it took; damping then takes it away.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Latency and jitter</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Fit all</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>All that is shown fills the device&apos;s workspace (W)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Fit organ</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The organ that is touched fills the device&apos;s workspace; else the one under the pointer or selected (O)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Fit lump</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>10 mm fill the device&apos;s workspace: where the hand touches, else under the pointer, else the newest finding (L)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What fills the workspace</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source> mm per mm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Scale</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Millimetres of the scene for a millimetre of the device</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The picture</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The patient</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Nothing: as it lies</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What the device turns with</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The picture: right is right in the view, however it is turned.
The patient: right is to the patient&apos;s left, up is to the head.
Nothing: the device&apos;s coordinates are the scene&apos;s, without scale and clutch.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Turns with</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 kHz</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rate of the servo loop</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ticks a second. A faster loop holds stiffer tissue where the device keeps up; see the jitter below.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Servo rate</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Any</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>CPU %1 alone</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>CPU of the servo loop</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Where the servo loop runs. One CPU alone helps where it is kept free of everything else; elsewhere &quot;Any&quot; lets
the loop go where there is room.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Servo CPU</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Nothing</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Clutch</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Centre</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Use of button %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Button %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Left hand</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The first two buttons change places</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>While held the device moves and the hand in the scene stays; the key C switches it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Puts the middle of the device&apos;s workspace in the middle of what fills it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Force on the hand %1 N of %2 N</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Energy %1 mJ · damping added %2 N</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Not real-time: the list of messages (F4) says how to permit it.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>palpate::ui::HintLine</name>
    <message>
        <source>The newest message; F4 shows all</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1
Press here or F4 for all messages</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No new message</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>palpate::ui::KeysCard</name>
    <message>
        <source>All keys</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>in the list: %1</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>palpate::ui::LawEditor</name>
    <message>
        <source>Load points…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Linear</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stiffer with depth</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ball on soft tissue</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Thin layer</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Click</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Measured points</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Law</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>By what law the force rises with the depth</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Take the points of a measured curve from a CSV file with depth_mm and force_N</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 in %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 [%2]</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Tables (*.csv);;All files (*)</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>palpate::ui::LawPlot</name>
    <message>
        <source>Force in newton by depth in millimetres</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Force [N] by depth [mm]. Drag a point; or choose one with ← → and move it with ↑ ↓</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Force [N] by depth [mm]</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 mm deep</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Force [N]</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>– – device %1 N/mm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>now %1 mm</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>palpate::ui::LiveTouch</name>
    <message>
        <source>With %1 at most %2 N/mm is shown.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 holds at most %2 N/mm here.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source> Its makers state no more.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source> Its force acts %1 ms late at %2 Hz: anything stiffer could make it oscillate.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source> A millimetre of the device is %1 mm of the scene: a smaller scale (panel Device) holds more.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 asks for %2 N/mm; %3 N/mm is felt, the most that %4 holds here%5.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source> beside the layers around it</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>palpate::ui::MapDisplay</name>
    <message>
        <source>Young&apos;s modulus, kPa</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>shear modulus, kPa</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>damping felt, N·s/mm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>friction, times the tissue&apos;s own</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>stiffness felt, N/mm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>stiffness felt, times the law</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>nothing said</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: nothing said</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>palpate::ui::MapEditor</name>
    <message>
        <source>Map</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>How the tissue varies over the surface</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>By name</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>None</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>By hand</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The arrays of the mesh whose names say what they are, such as StiffnessScale</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Varies</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What of the tissue varies</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stiffness</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Damping</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Friction</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>By</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Which array of the mesh, or which volume, says it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>In</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What the numbers are. Shear and Young&apos;s modulus differ by a factor of three: see what the scanner&apos;s manual says</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>say which…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Times the tissue&apos;s own</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>N/mm, as felt</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Shear modulus, kPa</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Young&apos;s modulus, kPa</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Contact radius in mm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source> mm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Of the finger that feels a modulus: the stiffness is 8 times radius times shear modulus</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Contact radius</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Keep numbers within</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Numbers beyond are taken as the nearest one within</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>At least</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>At most</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>to</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What the map says</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Colours the structure by numbers, with a legend</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Volume</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Volumes (*.vti *.mha *.mhd *.nrrd *.nhdr *.nii *.nii.gz);;All files (*)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Nothing</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Volume…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Own colour</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Say what the numbers of %1 are: shear and Young&apos;s modulus differ by a factor of three.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 varies by %2.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: %2 of %3 places say nothing. The tissue&apos;s own is felt there.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>palpate::ui::MessageBar</name>
    <message>
        <source> … and %1 more lines (F4)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show the list of messages (F4)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>1 older message waits (F4 shows all)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 older messages wait (F4 shows all)</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>palpate::ui::MessageList</name>
    <message>
        <source>Messages</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Copy (Ctrl+C)</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>palpate::ui::MessageRow</name>
    <message>
        <source>Close this message; the list of messages keeps it (F4)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Close this message</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>palpate::ui::Messages</name>
    <message>
        <source>%1: %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Told</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Warning</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Error</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Offer</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>palpate::ui::PalpationController</name>
    <message>
        <source>%1 mm is the deepest press: the scene is no larger.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Nothing that can be felt is in view.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>camera</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>presses %1 mm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>pressing %1 mm, slid off the edge</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>pressing %1 mm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>pressing %1 of %2 mm</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>palpate::ui::Playback</name>
    <message>
        <source>structure %1</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>palpate::ui::RecordedTouch</name>
    <message>
        <source>%1 ended at %2 s because the disk was full; what was felt after is not in it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 ended at %2 s because the disk could not be written; what was felt after is not in it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 was not closed (a crash, or a full disk): it ends at %2 s, and what was felt after is not in it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: %2 ticks were lost while it was recorded, because the disk was too slow.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>palpate::ui::SceneLoader</name>
    <message>
        <source>Nothing to open.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Reading %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Preparing for touch</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>its view</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the fields of it that this version does not know</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: opened together with another scene; not taken: %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>, </source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>palpate::ui::SessionPanel</name>
    <message>
        <source>Position and length</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Position / length [min:s]</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 ×</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Speed of playing; 1 × is as it was recorded</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Speed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No recording yet. Record one with R, or open a .palpate file.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1, %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 late, %2 lost</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>palpate::ui::StructureList</name>
    <message>
        <source>Structures</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Filter by name</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Filter the structures by name</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>List only what has these words in its name (Ctrl+F); Esc lists all</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Order and groups of the list</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Order</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>As opened</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>By name</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>By tissue, softest first</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>By layer, outermost first</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Groups</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>None</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>By file or folder</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>By layer, as felt</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>palpate::ui::StructureModel</name>
    <message>
        <source>Change %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>outermost</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>below %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 below</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 is shown. Click to hide it; what is hidden is not felt.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 is hidden. Click to show it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1, felt %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1
%2 triangles
Felt: %3</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>About the mesh of %1:
• %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 can be felt. Click to let the hand pass through it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The hand passes through %1. Click to feel it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Structure</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Shown</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Name and colour</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What was found in the mesh</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Can be felt</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Remove %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Remove %1 structures</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rename %1</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>palpate::ui::StructurePanel</name>
    <message>
        <source>Colour of the structure</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Colour</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Opacity in per cent</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Opacity [%]: what lies behind shows through</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Opacity</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 as felt [%2]: %3</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 in %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Own values</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Tissue</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>How the structure feels, by name</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Friction</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>How much the surface holds the fingertip, by name</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What is felt of it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Why the value was refused</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Felt, in order from outside</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What a hand meets first as it presses in, and what it meets through that (Ctrl+Down, Ctrl+Up in the list)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Felt</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No structure selected</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Source: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 takes %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>felt as at most %1 N/mm: the device holds %2 N/mm in all%3</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>felt as %1 N/mm: the device holds %2 N/mm in all%3</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>This law is refused: %1.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 N·s/mm is refused: the device can be damped with %2 N·s/mm at most. Enter that or less.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 Of that %2.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 N/mm is refused. %2 Enter %3 N/mm or less.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A law that rises by %1 N/mm where it is steepest is refused. %2 Enter numbers by which it rises by %3 N/mm or less.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Colour of %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show all</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Feel all</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>numbers chosen</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>shear modulus by MR elastography (PMC2894569), as a fingertip of 5 mm radius feels it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Very soft organ</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Soft organ</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Firm organ</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Firm lump</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Hard lump</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Bone</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Liver, healthy (2.3 kPa)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Liver, fibrotic (5.9 kPa)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Liver, malignant (10.1 kPa)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Liver, stiffer with depth</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>shape after Carter et al. 2001 (exponential), numbers chosen</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Soft ground under a ball</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>shape after Hertz 1882, numbers chosen</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Button that clicks</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>None</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Wet (0.05, chosen)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Moist (0.15, chosen)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Dry (0.40, chosen)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Change %1 structures</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 structures</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show only what is selected</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Feel only what is selected</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rename…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Remove from the scene</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>palpate::ui::StructureTree</name>
    <message>
        <source>Felt outermost</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Felt %1 below</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Other</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 (%2)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Hide all of %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show all of %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Let the hand pass through all of %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Feel all of %1</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>palpate::ui::Terms</name>
    <message>
        <source>Stiffness</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>force for each mm pressed in</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>newton per millimetre</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Damping</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>force against each mm/s of movement</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>newton seconds per millimetre</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Friction at rest</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>share of the normal force that holds</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Friction sliding</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>share of the normal force that drags while it slides</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Drag</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>force against each mm/s of sliding</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stiffness at first touch</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Growth with depth</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Greatest stiffness</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Young&apos;s modulus</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Radius of the ball</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Thickness of the layer</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Bonded to what is below</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stiffness before the click</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Force at which it gives way</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Force that it falls to</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Depth over which it falls</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stiffness after the click</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>palpate::ui::TouchChart</name>
    <message>
        <source>Chart of force and depth over the last ten seconds</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Force [N] and depth [mm] over the last 10 s</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>−10 s</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>−5 s</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>now</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Force [N]</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Depth [mm]</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>along the surface</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>palpate::ui::TouchPanel</name>
    <message>
        <source>%1 mm deep · %2 N/mm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>N</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Force in newton</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Force on the hand [N]</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Touched structure</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Touched structures, the outermost first, with their forces and depths</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Each layer that is touched, the outermost first: its share of the force [N],
and how deep the hand is in it [mm]</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Depth and stiffness</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Depth: from the outermost surface to the hand [mm]; stiffness as felt, of all layers that are touched [N/mm]</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Active constraints: planes of the surface that hold the hand back, at most 3.
Solver: time of one tick, not exceeded by 99 of 100 [µs].
Where more facets lie in one place than a tick has time for, it goes on from where it got to with the next.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Free space</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>nothing is touched</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>too many facets in this place: the force follows late</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>constraints %1 · solver %2 µs p99</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>constraints %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No hand</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>press on a structure to feel it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>constraints 0</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 mm deep · slid off the edge</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>slid off the edge</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>palpate::ui::ViewKeys</name>
    <message>
        <source>← → ↑ ↓</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>turn the camera by 15°; with Shift: move it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>+  −</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>zoom</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ctrl+← → ↑ ↓</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>move the place to press by 2 mm along the screen</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Enter</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>press there, let go</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Page down  up</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>press deeper, less deep by 0.5 mm</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>palpate::ui::VtkViewport</name>
    <message>
        <source>3D view</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>palpate::ui::WelcomePage</name>
    <message>
        <source>Try the phantom</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Recent</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Feel segmented anatomy</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Drop surface meshes or a scene here: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open anatomy…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open mesh or scene files (Ctrl+O)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open the phantom that comes with Palpate: a liver with two lumps, and a recorded palpation</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Then press P, drag to press, and set the depth with the wheel. Press ? for all keys.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
</TS>
