<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="en" sourcelanguage="en">
<context>
    <name>FindingsDesk</name>
    <message numerus="yes">
        <source>%n finding(s) exported to %1</source>
        <translation>
            <numerusform>%n finding exported to %1</numerusform>
            <numerusform>%n findings exported to %1</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Import %n finding(s)</source>
        <translation>
            <numerusform>Import %n finding</numerusform>
            <numerusform>Import %n findings</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n finding(s) imported from %1</source>
        <translation>
            <numerusform>%n finding imported from %1</numerusform>
            <numerusform>%n findings imported from %1</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>ResultTables</name>
    <message numerus="yes">
        <source>%n finding(s) were marked.</source>
        <translation>
            <numerusform>%n finding was marked.</numerusform>
            <numerusform>%n findings were marked.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>palpate::app::ExercisePart</name>
    <message numerus="yes">
        <source>%n hidden target(s)</source>
        <translation>
            <numerusform>%n hidden target</numerusform>
            <numerusform>%n hidden targets</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n marked</source>
        <translation>
            <numerusform>%n marked</numerusform>
            <numerusform>%n marked</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Exercise: %n hidden target(s)</source>
        <translation>
            <numerusform>Exercise: %n hidden target</numerusform>
            <numerusform>Exercise: %n hidden targets</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>palpate::app::ReportPart</name>
    <message numerus="yes">
        <source>Report written to %1; %n finding(s) marked outside of the recording are in a table of their own</source>
        <translation>
            <numerusform>Report written to %1; %n finding marked outside of the recording is in a table of its own</numerusform>
            <numerusform>Report written to %1; %n findings marked outside of the recording are in a table of their own</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>palpate::app::SceneChanges</name>
    <message numerus="yes">
        <source>%n note(s) on hidden targets are withheld</source>
        <translation>
            <numerusform>%n note on hidden targets is withheld</numerusform>
            <numerusform>%n notes on hidden targets are withheld</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>palpate::app::ShareDialog</name>
    <message numerus="yes">
        <source>%n message(s) not sent, because the receiver is too slow</source>
        <translation>
            <numerusform>%n message not sent, because the receiver is too slow</numerusform>
            <numerusform>%n messages not sent, because the receiver is too slow</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>palpate::app::TissueOffer</name>
    <message numerus="yes">
        <source>No preset matches the name of %n: “Firm organ”, 0.5 N/mm.</source>
        <translation>
            <numerusform>No preset matches the name of %n structure: “Firm organ”, 0.5 N/mm.</numerusform>
            <numerusform>No preset matches the names of %n structures: “Firm organ”, 0.5 N/mm.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>palpate::ui::RecordedTouch</name>
    <message numerus="yes">
        <source>%1 is damaged or was changed after recording: %n part(s) do not match their checksums and are left out. &quot;palpate session verify&quot; names the first part.</source>
        <translation>
            <numerusform>%1 is damaged or was changed after recording: %n part does not match its checksum and is left out. &quot;palpate session verify&quot; names this part.</numerusform>
            <numerusform>%1 is damaged or was changed after recording: %n parts do not match their checksums and are left out. &quot;palpate session verify&quot; names the first part.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>palpate::ui::StructureList</name>
    <message numerus="yes">
        <source>%n hidden target(s)</source>
        <translation>
            <numerusform>%n hidden target</numerusform>
            <numerusform>%n hidden targets</numerusform>
        </translation>
    </message>
</context>
</TS>
