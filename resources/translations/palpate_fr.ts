<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="fr" sourcelanguage="en">
<context>
    <name>CoordinatesChoice</name>
    <message>
        <source>RAS</source>
        <translation>RAS</translation>
    </message>
    <message>
        <source>Y up</source>
        <translation>Y haut</translation>
    </message>
    <message>
        <source>LPS</source>
        <translation>LPS</translation>
    </message>
    <message>
        <source>Coordinates: LPS</source>
        <translation>Coordonnées&#x202f;: LPS</translation>
    </message>
    <message>
        <source>The files count to the patient&apos;s left, back and head, as DICOM does</source>
        <translation>Les axes des fichiers vont vers la gauche, le dos et la tête du patient, comme en DICOM</translation>
    </message>
    <message>
        <source>Coordinates: RAS</source>
        <translation>Coordonnées&#x202f;: RAS</translation>
    </message>
    <message>
        <source>The files count to the patient&apos;s right, front and head, as older models of 3D Slicer do</source>
        <translation>Les axes des fichiers vont vers la droite, l’avant et la tête du patient, comme les anciens modèles de 3D Slicer</translation>
    </message>
    <message>
        <source>Coordinates: Y up</source>
        <translation>Coordonnées&#x202f;: Y haut</translation>
    </message>
    <message>
        <source>The files count to the patient&apos;s left, head and front, as modelling programs do</source>
        <translation>Les axes des fichiers vont vers la gauche, la tête et l’avant du patient, comme dans les modeleurs</translation>
    </message>
    <message>
        <source> and </source>
        <translation> et </translation>
    </message>
    <message>
        <source>%1 assumed</source>
        <translation>%1 supposé</translation>
    </message>
    <message>
        <source>The files&apos; coordinates are %1.</source>
        <translation>Les coordonnées des fichiers sont %1.</translation>
    </message>
    <message>
        <source>Not every file says along which axes it lies: %1 is assumed, and left and right may be exchanged. Click to say it.</source>
        <translation>Certains fichiers ne disent pas selon quels axes ils sont placés&#x202f;: %1 est supposé, gauche et droite peuvent être inversées. Cliquer pour l’indiquer.</translation>
    </message>
    <message>
        <source>The surfaces are a recording&apos;s and stay as they were felt.</source>
        <translation>Les surfaces sont d’un enregistrement et restent telles que palpées.</translation>
    </message>
    <message>
        <source>Coordinates: %1</source>
        <translation>Coordonnées&#x202f;: %1</translation>
    </message>
</context>
<context>
    <name>FeltLayers</name>
    <message>
        <source>%1 N</source>
        <translation>%1&#xa0;N</translation>
    </message>
    <message>
        <source>holds %1 N</source>
        <translation>adhère %1&#xa0;N</translation>
    </message>
    <message>
        <source>slides %1 N</source>
        <translation>glisse %1&#xa0;N</translation>
    </message>
    <message>
        <source>%1 N, pressed in %2 mm</source>
        <translation>%1 N, enfoncé de %2 mm</translation>
    </message>
</context>
<context>
    <name>FindingType</name>
    <message>
        <source>lump</source>
        <translation>nodule</translation>
    </message>
    <message>
        <source>hard area</source>
        <translation>zone dure</translation>
    </message>
    <message>
        <source>soft area</source>
        <translation>zone molle</translation>
    </message>
    <message>
        <source>landmark</source>
        <translation>repère</translation>
    </message>
    <message>
        <source>keep away</source>
        <translation>à éviter</translation>
    </message>
    <message>
        <source>other</source>
        <translation>autre</translation>
    </message>
</context>
<context>
    <name>FindingsDesk</name>
    <message>
        <source>Nothing is touched: press on the place first, then mark it (M).</source>
        <translation>Rien n’est touché&#x202f;: appuyer d’abord à l’endroit voulu, puis le marquer (M).</translation>
    </message>
    <message>
        <source>Finding %1</source>
        <translation>Point %1</translation>
    </message>
    <message>
        <source>%1 marked on %2 with %3 N</source>
        <translation>%1 marqué sur %2 avec %3&#xa0;N</translation>
    </message>
    <message>
        <source>Note %1</source>
        <translation>Note %1</translation>
    </message>
    <message>
        <source>No finding yet: press on a place and mark it (M).</source>
        <translation>Aucun point repéré&#x202f;: appuyer à un endroit et le marquer (M).</translation>
    </message>
    <message>
        <source>%1 keeps no view.</source>
        <translation>%1 n’a pas de vue.</translation>
    </message>
    <message>
        <source>%1 was not marked in a recording.</source>
        <translation>%1 n’a pas été marqué dans un enregistrement.</translation>
    </message>
    <message>
        <source>A recording is being made: stop it (R) to play.</source>
        <translation>Un enregistrement est en cours&#x202f;: l’arrêter (R) pour lire.</translation>
    </message>
    <message>
        <source>%1: the recording of %2 is not there any more.</source>
        <translation>%1&#x202f;: l’enregistrement de %2 n’est plus là.</translation>
    </message>
    <message>
        <source>%1: this is another recording than the one in which %2 was marked.</source>
        <translation>%1&#x202f;: cet enregistrement n’est pas celui où %2 a été marqué.</translation>
    </message>
    <message numerus="yes">
        <source>%n finding(s) written to %1</source>
        <translation>
            <numerusform>%n point repéré écrit dans %1</numerusform>
            <numerusform>%n points repérés écrits dans %1</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Import %n finding(s)</source>
        <translation>
            <numerusform>Importer %n point repéré</numerusform>
            <numerusform>Importer %n points repérés</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n finding(s) taken from %1</source>
        <translation>
            <numerusform>%n point repéré repris de %1</numerusform>
            <numerusform>%n points repérés repris de %1</numerusform>
        </translation>
    </message>
    <message>
        <source>, stiffness %1</source>
        <translation>, rigidité %1</translation>
    </message>
</context>
<context>
    <name>LumpLayout</name>
    <message>
        <source>%1 lies in %2 and is felt below it, as a layer: %3</source>
        <translation>%1 est dans %2 et se sent dessous, comme une couche&#x202f;: %3</translation>
    </message>
    <message>
        <source>its surface is open or inside out</source>
        <translation>sa surface est ouverte ou retournée</translation>
    </message>
    <message>
        <source>%1 is a lump itself</source>
        <translation>%1 est lui-même un nodule</translation>
    </message>
    <message>
        <source>a scene file could not name %1 alone</source>
        <translation>un fichier de scène ne pourrait pas nommer %1 seul</translation>
    </message>
    <message>
        <source>it reaches out of %1</source>
        <translation>elle dépasse de %1</translation>
    </message>
    <message>
        <source>it is as stiff as %1</source>
        <translation>aussi raide que %1</translation>
    </message>
    <message>
        <source>%1 seems to lie in %2, whose surface is open or inside out: it is felt neither through nor below it</source>
        <translation>%1 semble être dans %2, dont la surface est ouverte ou retournée&#x202f;: il ne se sent ni à travers ni dessous</translation>
    </message>
    <message>
        <source>%1 lies inside %2, %3 times as stiff (%4), and is felt through it</source>
        <translation>%1 est dans %2, %3 fois plus rigide (%4), et se sent à travers</translation>
    </message>
    <message>
        <source>a map varies how stiff it or %1 is</source>
        <translation>une carte fait varier sa rigidité ou celle de %1</translation>
    </message>
    <message>
        <source>how many times as stiff as %1 is it? Type it in What can be felt (B)</source>
        <translation>combien de fois plus rigide que %1&#x202f;? À saisir dans «&#x202f;Ce qui se sent&#x202f;» (B)</translation>
    </message>
</context>
<context>
    <name>MainWindow</name>
    <message>
        <source>Palpate[*]</source>
        <translation>Palpate[*]</translation>
    </message>
    <message>
        <source>Structures</source>
        <translation>Structures</translation>
    </message>
    <message>
        <source>Touch</source>
        <translation>Toucher</translation>
    </message>
    <message>
        <source>Findings and measures</source>
        <translation>Points et mesures</translation>
    </message>
    <message>
        <source>Device</source>
        <translation>Appareil</translation>
    </message>
    <message>
        <source>Session</source>
        <translation>Séance</translation>
    </message>
    <message>
        <source>Progress of opening</source>
        <translation>Progression de l’ouverture</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Interrompre</translation>
    </message>
    <message>
        <source>Research, training and planning rehearsal. Not a medical device.</source>
        <translation>Recherche, formation et répétition du geste planifié. Pas un dispositif médical.</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>Annuler</translation>
    </message>
    <message>
        <source>Undo: %1</source>
        <translation>Annuler&#x202f;: %1</translation>
    </message>
    <message>
        <source>Redo</source>
        <translation>Rétablir</translation>
    </message>
    <message>
        <source>Redo: %1</source>
        <translation>Rétablir&#x202f;: %1</translation>
    </message>
    <message>
        <source>Open what was recorded</source>
        <translation>Ouvrir ce qui a été enregistré</translation>
    </message>
    <message>
        <source>The phantom was not found beside the program.</source>
        <translation>Le fantôme est introuvable à côté du programme.</translation>
    </message>
    <message>
        <source>Opening was cancelled.</source>
        <translation>Ouverture interrompue.</translation>
    </message>
    <message>
        <source>Reading what varies over %1…</source>
        <translation>Lecture de ce qui varie sur %1…</translation>
    </message>
    <message>
        <source>The map of %1 is felt.</source>
        <translation>La carte de %1 se sent.</translation>
    </message>
    <message>
        <source>Open…</source>
        <translation>Ouvrir…</translation>
    </message>
    <message>
        <source>Open meshes, a scene or a recording</source>
        <translation>Ouvrir des maillages, une scène ou un enregistrement</translation>
    </message>
    <message>
        <source>Add to the scene…</source>
        <translation>Ajouter à la scène…</translation>
    </message>
    <message>
        <source>Open more meshes or a scene beside what is open</source>
        <translation>Ouvrir d’autres maillages ou une scène en plus</translation>
    </message>
    <message>
        <source>Close the scene</source>
        <translation>Fermer la scène</translation>
    </message>
    <message>
        <source>Close what is open</source>
        <translation>Fermer ce qui est ouvert</translation>
    </message>
    <message>
        <source>Save scene</source>
        <translation>Enregistrer la scène</translation>
    </message>
    <message>
        <source>Save the scene with its tissue</source>
        <translation>Enregistrer la scène avec ses tissus</translation>
    </message>
    <message>
        <source>Save scene as…</source>
        <translation>Enregistrer la scène sous…</translation>
    </message>
    <message>
        <source>Save the scene with its tissue to another file</source>
        <translation>Enregistrer la scène avec ses tissus dans un autre fichier</translation>
    </message>
    <message>
        <source>Snapshot</source>
        <translation>Photo</translation>
    </message>
    <message>
        <source>Save a picture of the view</source>
        <translation>Enregistrer une image de la vue</translation>
    </message>
    <message>
        <source>Import findings…</source>
        <translation>Importer des points…</translation>
    </message>
    <message>
        <source>Take the points of a 3D Slicer markups file (.mrk.json) as findings</source>
        <translation>Reprendre les points d’un fichier 3D Slicer (.mrk.json) comme points repérés</translation>
    </message>
    <message>
        <source>Export findings…</source>
        <translation>Exporter les points…</translation>
    </message>
    <message>
        <source>Write findings and notes as a table (CSV) or as 3D Slicer markups (.mrk.json)</source>
        <translation>Écrire points repérés et notes en tableau (CSV) ou en annotations 3D Slicer (.mrk.json)</translation>
    </message>
    <message>
        <source>Quit</source>
        <translation>Quitter</translation>
    </message>
    <message>
        <source>End Palpate</source>
        <translation>Quitter Palpate</translation>
    </message>
    <message>
        <source>Undo the newest change</source>
        <translation>Annuler le dernier changement</translation>
    </message>
    <message>
        <source>Do it again</source>
        <translation>Refaire</translation>
    </message>
    <message>
        <source>Find a structure…</source>
        <translation>Chercher une structure…</translation>
    </message>
    <message>
        <source>List only structures with these words in their names</source>
        <translation>Ne lister que les structures dont le nom contient ces mots</translation>
    </message>
    <message>
        <source>Rename the structure…</source>
        <translation>Renommer la structure…</translation>
    </message>
    <message>
        <source>Write another name for the selected structure</source>
        <translation>Donner un autre nom à la structure choisie</translation>
    </message>
    <message>
        <source>Remove from the scene</source>
        <translation>Retirer de la scène</translation>
    </message>
    <message>
        <source>Take the selected structures out of the scene; their files stay</source>
        <translation>Retirer de la scène les structures choisies&#x202f;; leurs fichiers restent</translation>
    </message>
    <message>
        <source>Fit</source>
        <translation>Cadrer</translation>
    </message>
    <message>
        <source>Fit everything into the view</source>
        <translation>Cadrer le tout dans la vue</translation>
    </message>
    <message>
        <source>Findings</source>
        <translation>Points repérés</translation>
    </message>
    <message>
        <source>Show the places marked as findings</source>
        <translation>Afficher les endroits marqués comme points repérés</translation>
    </message>
    <message>
        <source>What can be felt here</source>
        <translation>Ce qui est palpable ici</translation>
    </message>
    <message>
        <source>Colour organs by how much of the lumps below a hand feels, with a table</source>
        <translation>Colorer les organes selon ce qu’une main sent des nodules en dessous, avec un tableau</translation>
    </message>
    <message>
        <source>From the front (A)</source>
        <translation>De face (A)</translation>
    </message>
    <message>
        <source>From the back (P)</source>
        <translation>De dos (P)</translation>
    </message>
    <message>
        <source>From the left (L)</source>
        <translation>De la gauche (L)</translation>
    </message>
    <message>
        <source>From the right (R)</source>
        <translation>De la droite (R)</translation>
    </message>
    <message>
        <source>From the head (S)</source>
        <translation>De la tête (S)</translation>
    </message>
    <message>
        <source>From the feet (I)</source>
        <translation>Des pieds (I)</translation>
    </message>
    <message>
        <source>Oblique</source>
        <translation>Oblique</translation>
    </message>
    <message>
        <source>hold Space</source>
        <translation>tenir Espace</translation>
    </message>
    <message>
        <source>palpate while it is held</source>
        <translation>palper tant qu’elle est tenue</translation>
    </message>
    <message>
        <source>drag</source>
        <translation>glisser</translation>
    </message>
    <message>
        <source>camera: rotate · palpate: press and slide</source>
        <translation>caméra&#x202f;: tourner · palper&#x202f;: appuyer et glisser</translation>
    </message>
    <message>
        <source>click</source>
        <translation>clic</translation>
    </message>
    <message>
        <source>camera: select the structure (with Ctrl: one more)</source>
        <translation>caméra&#x202f;: choisir la structure (avec Ctrl&#x202f;: une de plus)</translation>
    </message>
    <message>
        <source>right drag</source>
        <translation>glisser droit</translation>
    </message>
    <message>
        <source>camera: zoom · palpate: rotate</source>
        <translation>caméra&#x202f;: zoomer · palper&#x202f;: tourner</translation>
    </message>
    <message>
        <source>middle drag</source>
        <translation>glisser milieu</translation>
    </message>
    <message>
        <source>pan</source>
        <translation>déplacer</translation>
    </message>
    <message>
        <source>wheel</source>
        <translation>molette</translation>
    </message>
    <message>
        <source>camera: zoom · palpate: depth in mm, or effort in N (with Ctrl: zoom)</source>
        <translation>caméra&#x202f;: zoomer · palper&#x202f;: profondeur en mm, ou effort en N (avec Ctrl&#x202f;: zoomer)</translation>
    </message>
    <message>
        <source>double-click</source>
        <translation>double-clic</translation>
    </message>
    <message>
        <source>centre the view on the point</source>
        <translation>centrer la vue sur le point</translation>
    </message>
    <message>
        <source>Let go</source>
        <translation>Lâcher</translation>
    </message>
    <message>
        <source>let go, then back to the camera</source>
        <translation>lâcher, puis revenir à la caméra</translation>
    </message>
    <message>
        <source>Ctrl+E  Ctrl+H</source>
        <translation>Ctrl+E  Ctrl+H</translation>
    </message>
    <message>
        <source>show or hide, feel or not</source>
        <translation>afficher ou masquer, sentir ou non</translation>
    </message>
    <message>
        <source>letters</source>
        <translation>lettres</translation>
    </message>
    <message>
        <source>go to the structure that begins so</source>
        <translation>aller à la structure qui commence ainsi</translation>
    </message>
    <message>
        <source>F2  Del</source>
        <translation>F2  Suppr</translation>
    </message>
    <message>
        <source>rename, remove from the scene</source>
        <translation>renommer, retirer de la scène</translation>
    </message>
    <message>
        <source>Ctrl+↓  ↑</source>
        <translation>Ctrl+↓  ↑</translation>
    </message>
    <message>
        <source>felt a layer deeper, farther out</source>
        <translation>senti une couche dessous, dessus</translation>
    </message>
    <message>
        <source>Enter  F2  Del</source>
        <translation>Entrée  F2  Suppr</translation>
    </message>
    <message>
        <source>in the findings: go there, edit, delete</source>
        <translation>points repérés&#x202f;: y aller, modifier, supprimer</translation>
    </message>
    <message>
        <source>Shift+Enter</source>
        <translation>Maj+Entrée</translation>
    </message>
    <message>
        <source>in the findings: play where it was marked</source>
        <translation>points repérés&#x202f;: lire au moment du marquage</translation>
    </message>
    <message>
        <source>Palpate</source>
        <translation>Palper</translation>
    </message>
    <message>
        <source>Press by effort</source>
        <translation>Appuyer par effort</translation>
    </message>
    <message>
        <source>Effort in, depth out: the force rises while the button is held, or is a pen&apos;s pressure, and a stiff place gives way less; off: the wheel says how deep</source>
        <translation>On donne l’effort, la profondeur suit&#x202f;: la force croît tant que le bouton est tenu, ou est la pression d’un stylet, et un endroit raide cède moins&#x202f;; désactivé&#x202f;: la molette règle la profondeur</translation>
    </message>
    <message>
        <source>Lift the hand</source>
        <translation>Lever la main</translation>
    </message>
    <message>
        <source>Move the device without the hand in the scene, as a mouse is lifted; again to go on</source>
        <translation>Déplacer l’appareil sans la main dans la scène, comme on lève une souris&#x202f;; encore une fois pour continuer</translation>
    </message>
    <message>
        <source>Record</source>
        <translation>Enregistrer</translation>
    </message>
    <message>
        <source>Record what the hand feels, at every moment</source>
        <translation>Enregistrer ce que sent la main, à chaque instant</translation>
    </message>
    <message>
        <source>Play</source>
        <translation>Lire</translation>
    </message>
    <message>
        <source>Play or pause the recording</source>
        <translation>Lire ou suspendre l’enregistrement</translation>
    </message>
    <message>
        <source>To the start</source>
        <translation>Au début</translation>
    </message>
    <message>
        <source>Back to the recording&apos;s start</source>
        <translation>Retour au début de l’enregistrement</translation>
    </message>
    <message>
        <source>Mark a finding</source>
        <translation>Marquer un point</translation>
    </message>
    <message>
        <source>Mark the place that is touched, in the scene and in the recording</source>
        <translation>Marquer l’endroit touché, dans la scène et dans l’enregistrement</translation>
    </message>
    <message>
        <source>Mark a finding and write…</source>
        <translation>Marquer un point et écrire…</translation>
    </message>
    <message>
        <source>Mark the place that is touched and write about it</source>
        <translation>Marquer l’endroit touché et écrire une note à son sujet</translation>
    </message>
    <message>
        <source>Note…</source>
        <translation>Note…</translation>
    </message>
    <message>
        <source>Write a note without a place</source>
        <translation>Écrire une note sans endroit</translation>
    </message>
    <message>
        <source>Next finding</source>
        <translation>Point suivant</translation>
    </message>
    <message>
        <source>Go to the next finding, in the view from which it was marked</source>
        <translation>Aller au point repéré suivant, dans la vue d’où il a été marqué</translation>
    </message>
    <message>
        <source>Previous finding</source>
        <translation>Point précédent</translation>
    </message>
    <message>
        <source>Go to the finding before</source>
        <translation>Aller au point repéré précédent</translation>
    </message>
    <message>
        <source>Results…</source>
        <translation>Résultats…</translation>
    </message>
    <message>
        <source>Forces, coverage and findings of the recording, and exports</source>
        <translation>Forces, couverture et points repérés de l’enregistrement, et exports</translation>
    </message>
    <message>
        <source>Keep the surfaces inside recordings</source>
        <translation>Garder les surfaces dans les enregistrements</translation>
    </message>
    <message>
        <source>One file then holds the whole session; it grows by what the meshes take</source>
        <translation>Un seul fichier contient alors toute la séance&#x202f;; il grossit de la taille des maillages</translation>
    </message>
    <message>
        <source>Zoom the hand&apos;s space to everything</source>
        <translation>Zoomer l’espace de la main sur tout</translation>
    </message>
    <message>
        <source>The device&apos;s whole way goes through all that is shown</source>
        <translation>Toute la course de l’appareil parcourt tout ce qui est affiché</translation>
    </message>
    <message>
        <source>Zoom the hand&apos;s space to the organ</source>
        <translation>Zoomer l’espace de la main sur l’organe</translation>
    </message>
    <message>
        <source>The device&apos;s whole way goes through the organ that is touched or pointed at</source>
        <translation>Toute la course de l’appareil parcourt l’organe touché ou pointé</translation>
    </message>
    <message>
        <source>Zoom the hand&apos;s space to the lump</source>
        <translation>Zoomer l’espace de la main sur le nodule</translation>
    </message>
    <message>
        <source>The device&apos;s whole way is 10 mm, about what is touched, pointed at or found</source>
        <translation>Toute la course de l’appareil vaut 10&#xa0;mm, autour de ce qui est touché, pointé ou repéré</translation>
    </message>
    <message>
        <source>All keys</source>
        <translation>Raccourcis</translation>
    </message>
    <message>
        <source>Show all keys</source>
        <translation>Afficher les raccourcis</translation>
    </message>
    <message>
        <source>&amp;File</source>
        <translation>&amp;Fichier</translation>
    </message>
    <message>
        <source>Open recent</source>
        <translation>Fichiers récents</translation>
    </message>
    <message>
        <source>&amp;Edit</source>
        <translation>É&amp;dition</translation>
    </message>
    <message>
        <source>&amp;View</source>
        <translation>&amp;Affichage</translation>
    </message>
    <message>
        <source>Appearance</source>
        <translation>Apparence</translation>
    </message>
    <message>
        <source>Text size</source>
        <translation>Taille du texte</translation>
    </message>
    <message>
        <source>&amp;Session</source>
        <translation>&amp;Séance</translation>
    </message>
    <message>
        <source>&amp;Help</source>
        <translation>Aid&amp;e</translation>
    </message>
    <message>
        <source>Tools</source>
        <translation>Outils</translation>
    </message>
    <message>
        <source>What the pointer or the device does</source>
        <translation>Ce que fait le pointeur ou l’appareil</translation>
    </message>
    <message>
        <source>Recording</source>
        <translation>Enregistrement</translation>
    </message>
    <message>
        <source>How touch runs</source>
        <translation>Marche du toucher</translation>
    </message>
    <message>
        <source>What the pointer does: it turns the view, or it presses this far along the line of sight [mm] or with this force [N]; the wheel sets it (P switches)</source>
        <translation>Ce que fait le pointeur&#x202f;: il tourne la vue, ou il appuie de tant le long du regard [mm] ou avec cette force [N]&#x202f;; la molette le règle (P change)</translation>
    </message>
    <message>
        <source>Pause</source>
        <translation>Pause</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>Arrêter</translation>
    </message>
    <message>
        <source>&amp;Device</source>
        <translation>A&amp;ppareil</translation>
    </message>
    <message>
        <source>P palpate, drag to press, wheel for depth</source>
        <translation>P palpe, glisser pour appuyer, molette pour la profondeur</translation>
    </message>
    <message>
        <source>Touch with the device; O or L zooms its space to the organ or lump, C lifts the hand</source>
        <translation>Toucher avec l’appareil&#x202f;; O ou L zoome son espace sur l’organe ou le nodule, C lève la main</translation>
    </message>
    <message>
        <source>Feel again</source>
        <translation>Sentir à nouveau</translation>
    </message>
    <message>
        <source>What can be felt</source>
        <translation>Ce qui est palpable</translation>
    </message>
    <message>
        <source>This anatomy is %1 mm across: its numbers are probably metres.</source>
        <translation>Cette anatomie mesure %1&#xa0;mm&#x202f;: ses nombres sont sans doute des mètres.</translation>
    </message>
    <message>
        <source>Read as metres</source>
        <translation>Lire en mètres</translation>
    </message>
    <message>
        <source>Stop the recording first: it holds the surfaces as they lie now.</source>
        <translation>Arrêtez d’abord l’enregistrement&#x202f;: il contient les surfaces telles que placées.</translation>
    </message>
    <message>
        <source>1 note on these files</source>
        <translation>1 remarque sur ces fichiers</translation>
    </message>
    <message>
        <source>%1 notes on these files</source>
        <translation>%1 remarques sur ces fichiers</translation>
    </message>
    <message>
        <source>%1  ·  %2 (F4 lists them)</source>
        <translation>%1  ·  %2 (F4 les liste)</translation>
    </message>
    <message>
        <source>Read again with coordinates %1: tissue and findings are kept, undo starts anew.</source>
        <translation>Relu avec les coordonnées %1&#x202f;: tissus et points repérés sont gardés, l’annulation repart de zéro.</translation>
    </message>
    <message>
        <source>As recorded, the fingertip is a ball of %1 mm radius (Session › Fingertip).</source>
        <translation>Comme à l’enregistrement, le bout du doigt est une boule de %1&#xa0;mm de rayon (Séance › Bout du doigt).</translation>
    </message>
    <message>
        <source>As recorded, the fingertip is a point (Session › Fingertip).</source>
        <translation>Comme à l’enregistrement, le bout du doigt est un point (Séance › Bout du doigt).</translation>
    </message>
    <message>
        <source>%1 can be played, but the meshes that it was made on are not where they were. Open them to see what was touched.</source>
        <translation>%1 peut être lu, mais les maillages d’origine ne sont plus à leur place. Ouvrez-les pour voir ce qui a été touché.</translation>
    </message>
    <message>
        <source>The scene was changed elsewhere</source>
        <translation>La scène a été modifiée ailleurs</translation>
    </message>
    <message>
        <source>%1 was saved by another window or program since it was opened here. To save it would replace what was saved there.</source>
        <translation>%1 a été enregistré par une autre fenêtre ou un autre programme depuis son ouverture ici. L’enregistrer d’ici remplacerait ce travail.</translation>
    </message>
    <message>
        <source>Save anyway</source>
        <translation>Enregistrer quand même</translation>
    </message>
    <message>
        <source>Save as…</source>
        <translation>Enregistrer sous…</translation>
    </message>
    <message>
        <source>Palpate scene (*.palpate.json)</source>
        <translation>Scène Palpate (*.palpate.json)</translation>
    </message>
    <message>
        <source>Scene saved to %1</source>
        <translation>Scène enregistrée dans %1</translation>
    </message>
    <message>
        <source>Unsaved changes</source>
        <translation>Changements non enregistrés</translation>
    </message>
    <message>
        <source>Save the changes to this scene?</source>
        <translation>Enregistrer les changements de cette scène&#x202f;?</translation>
    </message>
    <message>
        <source>Unsaved scene</source>
        <translation>Scène non enregistrée</translation>
    </message>
    <message>
        <source>%1 and %2 more</source>
        <translation>%1 et %2 de plus</translation>
    </message>
    <message>
        <source>%1[*] – Palpate</source>
        <translation>%1[*] – Palpate</translation>
    </message>
    <message>
        <source>Palpate ended unexpectedly and left unsaved changes of a scene.</source>
        <translation>Palpate s’est arrêté brutalement et a laissé des changements non enregistrés.</translation>
    </message>
    <message>
        <source>Restore</source>
        <translation>Récupérer</translation>
    </message>
    <message>
        <source>These changes were already restored in another window.</source>
        <translation>Ces changements ont déjà été récupérés dans une autre fenêtre.</translation>
    </message>
    <message>
        <source>Open anatomy</source>
        <translation>Ouvrir une anatomie</translation>
    </message>
    <message>
        <source>Anatomy, scenes and recordings (%1);;All files (*)</source>
        <translation>Anatomie, scènes et enregistrements (%1);;Tous les fichiers (*)</translation>
    </message>
    <message>
        <source>%1 files</source>
        <translation>%1 fichiers</translation>
    </message>
    <message>
        <source>Add %1 to the open scene?</source>
        <translation>Ajouter %1 à la scène ouverte&#x202f;?</translation>
    </message>
    <message>
        <source>Add</source>
        <translation>Ajouter</translation>
    </message>
    <message>
        <source>Open instead</source>
        <translation>Ouvrir seul</translation>
    </message>
    <message>
        <source>3D Slicer markups (*.mrk.json)</source>
        <translation>Annotations 3D Slicer (*.mrk.json)</translation>
    </message>
    <message>
        <source>Table (*.csv)</source>
        <translation>Tableau (*.csv)</translation>
    </message>
    <message>
        <source>Export findings</source>
        <translation>Exporter les points</translation>
    </message>
    <message>
        <source>Import findings</source>
        <translation>Importer des points</translation>
    </message>
    <message>
        <source>3D Slicer markups (*.mrk.json *.json);;All files (*)</source>
        <translation>Annotations 3D Slicer (*.mrk.json *.json);;Tous les fichiers (*)</translation>
    </message>
    <message>
        <source>%1; %2 more of that kind: Felt in the panel has each.</source>
        <translation>%1&#x202f;; %2 de plus de ce type&#x202f;: «&#x202f;Senti&#x202f;» dans le panneau les donne tous.</translation>
    </message>
    <message>
        <source>Feel what is inside below what is around it</source>
        <translation>Sentir ce qui est dedans sous ce qui l’entoure</translation>
    </message>
    <message>
        <source>All in one layer</source>
        <translation>Tout en une couche</translation>
    </message>
    <message>
        <source>Feel all in one layer</source>
        <translation>Tout sentir en une couche</translation>
    </message>
    <message>
        <source>%1 lies in %2, but this scene has all in one layer: it is not felt through %2.</source>
        <translation>%1 est dans %2, mais cette scène est en une seule couche&#x202f;: impossible à sentir à travers %2.</translation>
    </message>
    <message>
        <source>Feel it below</source>
        <translation>Sentir dessous</translation>
    </message>
    <message>
        <source>Add to the scene</source>
        <translation>Ajouter à la scène</translation>
    </message>
    <message>
        <source>Add %1</source>
        <translation>Ajouter %1</translation>
    </message>
    <message>
        <source>Add %1 structures</source>
        <translation>Ajouter %1 structures</translation>
    </message>
    <message>
        <source>%1 was added to the scene.</source>
        <translation>Ajout à la scène&#x202f;: %1.</translation>
    </message>
    <message>
        <source>%1 structures were added to the scene.</source>
        <translation>%1 structures ont été ajoutées à la scène.</translation>
    </message>
    <message>
        <source>What was added lies in or around other structures, but the layers that were set are kept.</source>
        <translation>L’ajout se trouve dans ou autour d’autres structures, mais les couches réglées sont gardées.</translation>
    </message>
    <message>
        <source>Tissue by names</source>
        <translation>Tissus selon les noms</translation>
    </message>
    <message>
        <source>%1 got its tissue by its name.</source>
        <translation>%1&#x202f;: tissu choisi d’après le nom.</translation>
    </message>
    <message>
        <source>%1 structures got tissue by their names.</source>
        <translation>%1 structures ont reçu leur tissu d’après leur nom.</translation>
    </message>
    <message>
        <source>Tissue as before</source>
        <translation>Tissus comme avant</translation>
    </message>
    <message>
        <source>Recorded to %1</source>
        <translation>Enregistré dans %1</translation>
    </message>
    <message>
        <source>Recording %1</source>
        <translation>Enregistrement %1</translation>
    </message>
    <message>
        <source>Picture saved to %1</source>
        <translation>Image enregistrée dans %1</translation>
    </message>
    <message>
        <source>%1: the picture could not be written. Is the folder writable and the disk not full?</source>
        <translation>%1&#x202f;: l’image n’a pas pu être écrite. Le dossier est-il accessible en écriture, et le disque non plein&#x202f;?</translation>
    </message>
    <message>
        <source>Next panel</source>
        <translation>Panneau suivant</translation>
    </message>
    <message>
        <source>The keys go to the next panel, and on to the view</source>
        <translation>Le clavier passe au panneau suivant, puis à la vue</translation>
    </message>
    <message>
        <source>Previous panel</source>
        <translation>Panneau précédent</translation>
    </message>
    <message>
        <source>The keys go to the panel before</source>
        <translation>Le clavier passe au panneau précédent</translation>
    </message>
    <message>
        <source>Hide or show all panels</source>
        <translation>Masquer ou afficher les panneaux</translation>
    </message>
    <message>
        <source>Messages</source>
        <translation>Messages</translation>
    </message>
    <message>
        <source>Show or hide the list of all messages since the start, with all notes on files</source>
        <translation>Afficher ou masquer la liste de tous les messages depuis le début, avec toutes les remarques sur les fichiers</translation>
    </message>
    <message>
        <source>Engineering</source>
        <translation>Technique</translation>
    </message>
    <message>
        <source>Show or hide solver, servo loop and device in numbers</source>
        <translation>Afficher ou masquer en chiffres le solveur, la boucle et l’appareil</translation>
    </message>
    <message>
        <source>Single-letter keys</source>
        <translation>Touches à une lettre</translation>
    </message>
    <message>
        <source>Commands by one letter; off: letters do nothing, for speech input and for hands that touch keys by chance</source>
        <translation>Commandes à une lettre&#x202f;; sinon les lettres ne font rien, pour la saisie vocale et les mains qui touchent le clavier par mégarde</translation>
    </message>
    <message>
        <source>%1: %2 (%3)</source>
        <translation>%1&#x202f;: %2 (%3)</translation>
    </message>
    <message>
        <source>Forces may stutter: %1: %2. %3</source>
        <translation>La force peut saccader&#x202f;: %1&#x202f;: %2. %3</translation>
    </message>
    <message>
        <source>Touching with the %1</source>
        <translation>Toucher avec&#x202f;: %1</translation>
    </message>
    <message>
        <source>Turning the view</source>
        <translation>Rotation de la vue</translation>
    </message>
    <message>
        <source>Stop reading; what was open stays</source>
        <translation>Arrêter la lecture&#x202f;; ce qui était ouvert reste</translation>
    </message>
    <message>
        <source>Dent under the finger</source>
        <translation>Creux sous le doigt</translation>
    </message>
    <message>
        <source>Draw soft tissue bent where it is pressed, with a fine grid on it</source>
        <translation>Dessiner le tissu mou enfoncé là où l’on appuie, avec une fine grille</translation>
    </message>
    <message>
        <source>Palpate with the pointer: drag to press, wheel for depth or effort; off: the pointer moves the camera</source>
        <translation>Palper avec le pointeur&#x202f;: glisser pour appuyer, molette pour la profondeur ou l’effort&#x202f;; sinon le pointeur déplace la caméra</translation>
    </message>
    <message>
        <source>P palpate, hold to press harder, wheel for the hardest press</source>
        <translation>P palpe, maintenir appuie plus fort, la molette règle l’appui le plus fort</translation>
    </message>
    <message>
        <source>The pointer says where, the SpaceMouse how hard: push its puck down. P palpate, wheel for the hardest press</source>
        <translation>Le pointeur dit où, la SpaceMouse avec quelle force&#x202f;: poussez son palet vers le bas. P palpe, la molette règle la pression la plus forte</translation>
    </message>
    <message>
        <source>Feel it as a layer</source>
        <translation>Le sentir comme une couche</translation>
    </message>
    <message numerus="yes">
        <source>%n did not: felt as “Firm organ”, 0.5 N/mm.</source>
        <translation>
            <numerusform>%n non&#x202f;: ressentie comme «&#x202f;organe ferme&#x202f;», 0,5 N/mm.</numerusform>
            <numerusform>%n non&#x202f;: ressenties comme «&#x202f;organe ferme&#x202f;», 0,5 N/mm.</numerusform>
        </translation>
    </message>
    <message>
        <source>Making the surface of %1…</source>
        <translation>Création de la surface de %1…</translation>
    </message>
    <message>
        <source>%1 × %2 × %3 mm</source>
        <translation>%1 × %2 × %3 mm</translation>
    </message>
    <message>
        <source>%1 is a staircase of about %2 voxels: the hand feels its steps.</source>
        <translation>%1 est un escalier de voxels d’environ %2&#x202f;: la main sent ses marches.</translation>
    </message>
    <message>
        <source>%1 surfaces are staircases, of about %2 voxels: the hand feels their steps.</source>
        <translation>%1 surfaces sont des escaliers de voxels d’environ %2&#x202f;: la main sent leurs marches.</translation>
    </message>
    <message>
        <source>Smooth it</source>
        <translation>Lisser</translation>
    </message>
    <message>
        <source>Smooth them</source>
        <translation>Les lisser</translation>
    </message>
    <message>
        <source>%1 is inside out: felt from within only.</source>
        <translation>%1 est à l’envers&#x202f;: sentie de l’intérieur seulement.</translation>
    </message>
    <message>
        <source>%1 surfaces are inside out: felt from within only.</source>
        <translation>%1 surfaces sont à l’envers&#x202f;: senties de l’intérieur seulement.</translation>
    </message>
    <message>
        <source>Turn it around</source>
        <translation>La retourner</translation>
    </message>
    <message>
        <source>Turn them around</source>
        <translation>Les retourner</translation>
    </message>
    <message>
        <source>%1 has another surface now.</source>
        <translation>%1 a maintenant une autre surface.</translation>
    </message>
</context>
<context>
    <name>MeasuresDialog</name>
    <message>
        <source>Data table (CSV)</source>
        <translation>Tableau (CSV)</translation>
    </message>
    <message>
        <source>Data table (*.csv)</source>
        <translation>Tableau (*.csv)</translation>
    </message>
    <message>
        <source>Path and map for 3D Slicer</source>
        <translation>Trajet et carte pour 3D Slicer</translation>
    </message>
    <message>
        <source>VTK poly data (*.vtp)</source>
        <translation>VTK poly data (*.vtp)</translation>
    </message>
    <message>
        <source>Results (JSON)</source>
        <translation>Résultats (JSON)</translation>
    </message>
    <message>
        <source>Results (*.json)</source>
        <translation>Résultats (*.json)</translation>
    </message>
    <message>
        <source>Results of %1</source>
        <translation>Résultats de %1</translation>
    </message>
    <message>
        <source>Results of the session</source>
        <translation>Résultats de la séance</translation>
    </message>
    <message>
        <source>Measuring…</source>
        <translation>Mesure…</translation>
    </message>
    <message>
        <source>What became of the newest export</source>
        <translation>Ce qu’est devenu le dernier export</translation>
    </message>
    <message>
        <source>Progress of the export</source>
        <translation>Progression de l’export</translation>
    </message>
    <message>
        <source>Cancel the export</source>
        <translation>Annuler l’export</translation>
    </message>
    <message>
        <source>Copy</source>
        <translation>Copier</translation>
    </message>
    <message>
        <source>Copy all tables, to be pasted into a spreadsheet (Ctrl+C)</source>
        <translation>Copier tous les tableaux, à coller dans un tableur (Ctrl+C)</translation>
    </message>
    <message>
        <source>Every moment with its time, places, forces, depth and events</source>
        <translation>Chaque instant avec temps, lieux, forces, profondeur et événements</translation>
    </message>
    <message>
        <source>The path of the hand, and beside it the touched surface with time spent and peak force</source>
        <translation>Le trajet de la main et, à côté, la surface touchée avec temps passé et force maximale</translation>
    </message>
    <message>
        <source>The tables above, and more, for a program</source>
        <translation>Les tableaux ci-dessus, et plus, pour un programme</translation>
    </message>
    <message>
        <source>Copied: paste it into a spreadsheet.</source>
        <translation>Copié&#x202f;: à coller dans un tableur.</translation>
    </message>
    <message>
        <source>Nothing was written: %1 is there already. Choose it by its whole name to replace it.</source>
        <translation>Rien n’a été écrit&#x202f;: %1 existe déjà. Choisissez-le par son nom complet pour le remplacer.</translation>
    </message>
    <message>
        <source>Nothing was written: %1 ends in %2. A name for %3 ends in %4.</source>
        <translation>Rien n’a été écrit&#x202f;: %1 finit par %2. Un nom pour %3 finit par %4.</translation>
    </message>
    <message>
        <source>Written to %1.</source>
        <translation>Écrit dans %1.</translation>
    </message>
    <message>
        <source>Written to %1 and %2.</source>
        <translation>Écrit dans %1 et %2.</translation>
    </message>
    <message>
        <source>The path is written to %1; the map is not: %2</source>
        <translation>Le trajet est écrit dans %1&#x202f;; la carte ne l’est pas&#x202f;: %2</translation>
    </message>
</context>
<context>
    <name>RecordingControl</name>
    <message>
        <source>Length of the recording [min:s]; moments of 1 ms that were late, because the computer was busy: nothing was felt in them; moments that were lost, because the disk was slow: they were felt and are not in it</source>
        <translation>Durée de l’enregistrement [min:s]&#x202f;; instants de 1&#xa0;ms en retard, l’ordinateur étant occupé&#x202f;: rien n’y a été senti&#x202f;; instants perdus, le disque étant lent&#x202f;: ils ont été sentis et n’y sont pas</translation>
    </message>
    <message>
        <source>Recording</source>
        <translation>Enregistrement</translation>
    </message>
    <message>
        <source>A recording is running. End it and close?</source>
        <translation>Un enregistrement est en cours. L’arrêter et fermer&#x202f;?</translation>
    </message>
    <message>
        <source>What was felt until now is kept in %1.</source>
        <translation>Ce qui a été senti jusqu’ici est gardé dans %1.</translation>
    </message>
    <message>
        <source>End the recording</source>
        <translation>Finir l’enregistrement</translation>
    </message>
    <message>
        <source>Go on recording</source>
        <translation>Continuer</translation>
    </message>
    <message>
        <source>● recording %1, the disk does not answer</source>
        <translation>● enregistre %1, le disque ne répond pas</translation>
    </message>
    <message>
        <source>● recording %1, %2</source>
        <translation>● enregistre %1, %2</translation>
    </message>
    <message>
        <source>recording failed at %1</source>
        <translation>échec de l’enregistrement à %1</translation>
    </message>
    <message>
        <source>%1 ended by itself</source>
        <translation>%1 s’est arrêté seul</translation>
    </message>
</context>
<context>
    <name>ResultTables</name>
    <message>
        <source>Session</source>
        <translation>Séance</translation>
    </message>
    <message>
        <source>Duration</source>
        <translation>Durée</translation>
    </message>
    <message>
        <source>In contact</source>
        <translation>En contact</translation>
    </message>
    <message>
        <source>Contacts</source>
        <translation>Contacts</translation>
    </message>
    <message>
        <source>Path of the hand</source>
        <translation>Trajet de la main</translation>
    </message>
    <message>
        <source>Path on the surface</source>
        <translation>Trajet en surface</translation>
    </message>
    <message>
        <source>Moments late</source>
        <translation>Instants en retard</translation>
    </message>
    <message>
        <source>Moments lost</source>
        <translation>Instants perdus</translation>
    </message>
    <message>
        <source>%1 mm</source>
        <translation>%1&#xa0;mm</translation>
    </message>
    <message>
        <source>not said</source>
        <translation>non indiqué</translation>
    </message>
    <message>
        <source>Touch</source>
        <translation>Toucher</translation>
    </message>
    <message>
        <source>Force and depth</source>
        <translation>Force et profondeur</translation>
    </message>
    <message>
        <source>Time spent [s]</source>
        <translation>Temps passé [s]</translation>
    </message>
    <message>
        <source>Mean [N]</source>
        <translation>Moyenne [N]</translation>
    </message>
    <message>
        <source>Median [N]</source>
        <translation>Médiane [N]</translation>
    </message>
    <message>
        <source>Nearly highest [N]</source>
        <translation>Presque max. [N]</translation>
    </message>
    <message>
        <source>Peak [N]</source>
        <translation>Maximum [N]</translation>
    </message>
    <message>
        <source>Deepest [mm]</source>
        <translation>Plus profond [mm]</translation>
    </message>
    <message>
        <source>Presses</source>
        <translation>Appuis</translation>
    </message>
    <message>
        <source>All</source>
        <translation>Tout</translation>
    </message>
    <message>
        <source>Search and press</source>
        <translation>Recherche et appui</translation>
    </message>
    <message>
        <source>Hand</source>
        <translation>Main</translation>
    </message>
    <message>
        <source>Phases</source>
        <translation>Phases</translation>
    </message>
    <message>
        <source>Searching</source>
        <translation>Recherche</translation>
    </message>
    <message>
        <source>Pressing</source>
        <translation>Appui</translation>
    </message>
    <message>
        <source>Share of the surface that was examined: within %1, the fingertip&apos;s radius</source>
        <translation>Part de la surface examinée&#x202f;: à moins de %1, le rayon du bout du doigt</translation>
    </message>
    <message>
        <source>Share of the surface that was examined: within %1</source>
        <translation>Part de la surface examinée&#x202f;: à moins de %1</translation>
    </message>
    <message>
        <source>Surface</source>
        <translation>Surface</translation>
    </message>
    <message>
        <source>Area [cm²]</source>
        <translation>Aire [cm²]</translation>
    </message>
    <message>
        <source>Examined [%]</source>
        <translation>Examiné [%]</translation>
    </message>
    <message>
        <source>Longest time at one place [s]</source>
        <translation>Temps le plus long à un endroit [s]</translation>
    </message>
    <message>
        <source>its mesh is not there</source>
        <translation>son maillage est absent</translation>
    </message>
    <message>
        <source>Findings</source>
        <translation>Points repérés</translation>
    </message>
    <message>
        <source>Finding</source>
        <translation>Point</translation>
    </message>
    <message>
        <source>On</source>
        <translation>Sur</translation>
    </message>
    <message>
        <source>Marked</source>
        <translation>Marqué</translation>
    </message>
    <message>
        <source>First touched</source>
        <translation>Premier toucher</translation>
    </message>
    <message>
        <source>Times returned</source>
        <translation>Retours</translation>
    </message>
    <message>
        <source>never</source>
        <translation>jamais</translation>
    </message>
    <message>
        <source>Notes</source>
        <translation>Notes</translation>
    </message>
    <message>
        <source>Note</source>
        <translation>Note</translation>
    </message>
    <message>
        <source>Written</source>
        <translation>Écrite</translation>
    </message>
    <message>
        <source>Findings, layer by layer</source>
        <translation>Points repérés par couche</translation>
    </message>
    <message>
        <source>Felt when marked</source>
        <translation>Senti au marquage</translation>
    </message>
    <message>
        <source>Structure</source>
        <translation>Structure</translation>
    </message>
    <message>
        <source>Force [N]</source>
        <translation>Force [N]</translation>
    </message>
    <message>
        <source>Depth [mm]</source>
        <translation>Profondeur [mm]</translation>
    </message>
    <message>
        <source>Nearly highest: the force that 95 % of the contact stayed below. Research measures, not a diagnosis.</source>
        <translation>Presque max.&#x202f;: la force sous laquelle sont restés 95&#x202f;% du contact. Mesures de recherche, pas un diagnostic.</translation>
    </message>
    <message>
        <source>Lump</source>
        <translation>Nodule</translation>
    </message>
    <message>
        <source>In</source>
        <translation>Dans</translation>
    </message>
    <message>
        <source>Felt by a trained hand from [cm²]</source>
        <translation>Senti par une main exercée depuis [cm²]</translation>
    </message>
    <message>
        <source>Of that pressed hard enough [%]</source>
        <translation>Dont assez appuyé [%]</translation>
    </message>
    <message>
        <source>not by hand</source>
        <translation>pas à la main</translation>
    </message>
    <message>
        <source>Lumps: what was recorded, and what the model predicts (an estimate)</source>
        <translation>Masses&#x202f;: enregistré et prédit par le modèle (estimation)</translation>
    </message>
    <message>
        <source>Greatest change recorded [%]</source>
        <translation>Plus grand changement enregistré [%]</translation>
    </message>
    <message>
        <source>Predicted by the model [%]</source>
        <translation>Prédit par le modèle [%]</translation>
    </message>
</context>
<context>
    <name>SceneDocument</name>
    <message>
        <source>Mark %1</source>
        <translation>Marquer %1</translation>
    </message>
    <message>
        <source>Unsaved changes would be lost in a crash; save the scene. %1</source>
        <translation>Les modifications non enregistrées seraient perdues en cas de plantage&#x202f;; enregistrez la scène. %1</translation>
    </message>
</context>
<context>
    <name>palpate::Message</name>
    <message>
        <source>%1: %2</source>
        <translation>%1&#x202f;: %2</translation>
    </message>
    <message>
        <source>%1; %2</source>
        <translation>%1&#x202f;; %2</translation>
    </message>
    <message>
        <source>(%1 mm, %2 N)</source>
        <translation>(%1 mm, %2 N)</translation>
    </message>
    <message>
        <source>found %1, expected finite numbers</source>
        <translation>trouvé : %1, des nombres finis étaient attendus</translation>
    </message>
    <message>
        <source>found %1, expected the first point at 0 mm and 0 N</source>
        <translation>trouvé : %1, le premier point était attendu à 0 mm et 0 N</translation>
    </message>
    <message>
        <source>found %1, expected a force of at least 0 N</source>
        <translation>trouvé : %1, une force d’au moins 0 N était attendue</translation>
    </message>
    <message>
        <source>found %1, expected a depth of %2 to %3 mm</source>
        <translation>trouvé : %1, une profondeur de %2 à %3 mm était attendue</translation>
    </message>
    <message>
        <source>found %1, a slope of %2 N/mm from the previous point, expected at most %3 N/mm</source>
        <translation>trouvé : %1, une pente de %2 N/mm depuis le point précédent, au plus %3 N/mm étaient attendus</translation>
    </message>
    <message>
        <source>found more points, expected 2 to %1</source>
        <translation>trop de points trouvés, 2 à %1 étaient attendus</translation>
    </message>
    <message>
        <source>found %1 points, expected 2 to %2</source>
        <translation>%1 points trouvés, 2 à %2 étaient attendus</translation>
    </message>
    <message>
        <source>point %1 of %2: %3</source>
        <translation>point %1 sur %2 : %3</translation>
    </message>
    <message>
        <source>%1: found %2, expected %3 to %4 %5</source>
        <translation>%1 : trouvé : %2, attendu : de %3 à %4 %5</translation>
    </message>
    <message>
        <source>%1: found %2, expected at most %3 (%4)</source>
        <translation>%1 : trouvé : %2, attendu : au plus %3 (%4)</translation>
    </message>
    <message>
        <source>the force falls by %1 N/mm, expected at most %2 N/mm</source>
        <translation>la force baisse de %1 N/mm, au plus %2 N/mm étaient attendus</translation>
    </message>
    <message>
        <source>No such file or directory</source>
        <translation>Fichier ou dossier introuvable</translation>
    </message>
    <message>
        <source>Permission denied</source>
        <translation>Permission refusée</translation>
    </message>
    <message>
        <source>Read-only file system</source>
        <translation>Système de fichiers en lecture seule</translation>
    </message>
    <message>
        <source>No space left on device</source>
        <translation>Plus de place sur le disque</translation>
    </message>
    <message>
        <source>Disk quota exceeded</source>
        <translation>Quota disque dépassé</translation>
    </message>
    <message>
        <source>File too large</source>
        <translation>Fichier trop volumineux</translation>
    </message>
    <message>
        <source>Is a directory</source>
        <translation>Est un dossier</translation>
    </message>
    <message>
        <source>Not a directory</source>
        <translation>N’est pas un dossier</translation>
    </message>
    <message>
        <source>File exists</source>
        <translation>Le fichier existe déjà</translation>
    </message>
    <message>
        <source>Input/output error</source>
        <translation>Erreur d’entrée/sortie</translation>
    </message>
    <message>
        <source>File name too long</source>
        <translation>Nom de fichier trop long</translation>
    </message>
    <message>
        <source>Too many open files</source>
        <translation>Trop de fichiers ouverts</translation>
    </message>
    <message>
        <source>not a file</source>
        <translation>n’est pas un fichier</translation>
    </message>
    <message>
        <source>%1: cannot be written: %2; choose another folder</source>
        <translation>%1 : écriture impossible : %2 ; choisissez un autre dossier</translation>
    </message>
    <message>
        <source>hand script: found no target, expected at least one</source>
        <translation>script de main : aucune cible trouvée, au moins une était attendue</translation>
    </message>
    <message>
        <source>hand script: target %1 is not finite</source>
        <translation>script de main : la cible %1 n’est pas finie</translation>
    </message>
    <message>
        <source>hand script: found target %1 at %2 s, expected a time after %3 s</source>
        <translation>script de main : cible %1 trouvée à %2 s, un temps après %3 s était attendu</translation>
    </message>
    <message>
        <source>hand script: target %1 needs too high a speed</source>
        <translation>script de main : la cible %1 exige une vitesse trop élevée</translation>
    </message>
    <message>
        <source>the motion to play has no rows</source>
        <translation>le mouvement à rejouer n’a pas de lignes</translation>
    </message>
    <message>
        <source>%1 belongs to another user, expected you or root as its owner</source>
        <translation>%1 appartient à un autre utilisateur, vous ou root étiez attendus comme propriétaire</translation>
    </message>
    <message>
        <source>others may write to %1; remove this permission with: chmod go-w &apos;%1&apos;</source>
        <translation>d’autres peuvent écrire dans %1 ; retirez ce droit par chmod go-w &quot;%1&quot;</translation>
    </message>
    <message>
        <source>%1: skipped, %2</source>
        <translation>%1 : ignoré, %2</translation>
    </message>
    <message>
        <source>not a Qt plugin</source>
        <translation>pas un greffon Qt</translation>
    </message>
    <message>
        <source>a plugin of another program: found &quot;%1&quot;, expected &quot;%2&quot;</source>
        <translation>un greffon d’un autre programme : trouvé « %1 », attendu « %2 »</translation>
    </message>
    <message>
        <source>built for device API %1, this program has %2; rebuild it against this version</source>
        <translation>construit pour l’API d’appareil %1, ce programme a %2 ; reconstruisez-le pour cette version</translation>
    </message>
    <message>
        <source>found apiVersion %1 in its metadata, expected %2, which it was built for; correct its plugin.json and rebuild it</source>
        <translation>apiVersion %1 trouvée dans ses métadonnées, %2 était attendue, pour laquelle il est construit ; corrigez plugin.json et reconstruisez-le</translation>
    </message>
    <message>
        <source>found the id &quot;%1&quot; in its metadata, expected lowercase letters, digits and dashes</source>
        <translation>identifiant « %1 » trouvé dans ses métadonnées, des minuscules, chiffres et tirets étaient attendus</translation>
    </message>
    <message>
        <source>its id &quot;%1&quot; belongs to a built-in device</source>
        <translation>son identifiant « %1 » est celui d’un appareil intégré</translation>
    </message>
    <message>
        <source>its metadata has no &quot;%1&quot;</source>
        <translation>ses métadonnées n’ont pas « %1 »</translation>
    </message>
    <message>
        <source>%1: skipped, %2 has the same id and comes first</source>
        <translation>%1 : ignoré, %2 a le même identifiant et vient d’abord</translation>
    </message>
    <message>
        <source>found no device plugin called &quot;%1&quot;, expected one of: %2 (&quot;palpate devices&quot; also lists the built-in devices)</source>
        <translation>aucun greffon d’appareil nommé « %1 » trouvé, attendu l’un de : %2 (« palpate devices » liste aussi les appareils intégrés)</translation>
    </message>
    <message>
        <source>%1: its root object is not a device plugin</source>
        <translation>%1 : son objet racine n’est pas un greffon d’appareil</translation>
    </message>
    <message>
        <source>%1: skipped, it hung when it was started</source>
        <translation>%1 : ignoré, bloqué au démarrage</translation>
    </message>
    <message>
        <source>%1: could not be tried: %2: %3</source>
        <translation>%1 : essai impossible : %2 : %3</translation>
    </message>
    <message>
        <source>%1: skipped, it crashed when it was started (signal %2)</source>
        <translation>%1 : ignoré, plantage au démarrage (signal %2)</translation>
    </message>
    <message>
        <source>%1: skipped, it ended the process when it was started</source>
        <translation>%1 : ignoré, a mis fin au processus au démarrage</translation>
    </message>
    <message>
        <source>%1: skipped, it failed when it was started: %2</source>
        <translation>%1 : ignoré, échec au démarrage : %2</translation>
    </message>
    <message>
        <source>%1: skipped, it failed when it was started</source>
        <translation>%1 : ignoré, échec au démarrage</translation>
    </message>
    <message>
        <source>simulated hand: %1: found %2, expected at least %3</source>
        <translation>main simulée : %1 : trouvé %2, attendu au moins %3</translation>
    </message>
    <message>
        <source>simulated hand: %1: found %2, expected at most %3</source>
        <translation>main simulée : %1 : trouvé %2, attendu au plus %3</translation>
    </message>
    <message>
        <source>found a mesh of %1 mm from its centre to its side, expected at most %2 mm</source>
        <translation>maillage de %1 mm du centre au côté trouvé, au plus %2 mm étaient attendus</translation>
    </message>
    <message>
        <source>is not deeper than the previous knot</source>
        <translation>n’est pas plus profond que le précédent</translation>
    </message>
    <message>
        <source>has a steeper slope than any law</source>
        <translation>a une pente plus forte que toute loi</translation>
    </message>
    <message>
        <source>follows a cell with a force below 0</source>
        <translation>suit une cellule dont la force est inférieure à 0</translation>
    </message>
    <message>
        <source>has a number that is not finite</source>
        <translation>contient un nombre non fini</translation>
    </message>
    <message>
        <source>is not at 0 mm and 0 N</source>
        <translation>n’est pas à 0 mm et 0 N</translation>
    </message>
    <message>
        <source>has a force below 0</source>
        <translation>a une force inférieure à 0</translation>
    </message>
    <message>
        <source>ends with a slope below 0 or steeper than any law</source>
        <translation>finit par une pente inférieure à 0 ou plus forte que toute loi</translation>
    </message>
    <message>
        <source>force table: found %1 knots, expected 1 to %2</source>
        <translation>table de force : %1 nœuds trouvés, 1 à %2 étaient attendus</translation>
    </message>
    <message>
        <source>force table: knot %1 of %2 %3</source>
        <translation>table de force : le nœud %1 sur %2 %3</translation>
    </message>
    <message>
        <source>force table: found %1 bytes, expected %2 for each knot</source>
        <translation>table de force : %1 octets trouvés, %2 par nœud étaient attendus</translation>
    </message>
</context>
<context>
    <name>palpate::app::Fingertip</name>
    <message>
        <source>Ball of %1 mm radius</source>
        <translation>Boule de %1&#xa0;mm de rayon</translation>
    </message>
    <message>
        <source>Point</source>
        <translation>Point</translation>
    </message>
    <message>
        <source>Fingertip</source>
        <translation>Bout du doigt</translation>
    </message>
    <message>
        <source>What touches: a point feels every facet, a ball slides over small pits as a finger does</source>
        <translation>Ce qui touche&#x202f;: un point sent chaque facette, une boule glisse sur les petits creux comme un doigt</translation>
    </message>
</context>
<context>
    <name>palpate::app::Help</name>
    <message>
        <source>Documents</source>
        <translation>Documents</translation>
    </message>
    <message>
        <source>Open the folder of documents: keys, recordings, measures, glossary, devices</source>
        <translation>Ouvrir le dossier des documents&#x202f;: raccourcis, enregistrements, mesures, glossaire, appareils</translation>
    </message>
    <message>
        <source>About Palpate</source>
        <translation>À propos de Palpate</translation>
    </message>
    <message>
        <source>Version, build and licences, to copy for a report</source>
        <translation>Version, build et licences, à copier pour un rapport</translation>
    </message>
    <message>
        <source>The documents were not found beside the program.</source>
        <translation>Les documents n’ont pas été trouvés à côté du programme.</translation>
    </message>
    <message>
        <source>Nothing here opens folders; the documents are in %1</source>
        <translation>Rien ici n’ouvre les dossiers&#x202f;; les documents sont dans %1</translation>
    </message>
    <message>
        <source>Research, training and planning rehearsal. Not a medical device.

Palpate is free software under the BSD 3-Clause licence. It is made with Qt (LGPL 3), VTK (BSD 3-Clause), Eigen (MPL 2.0), SQLite (public domain), hidapi (BSD) and CLI11 (BSD 3-Clause).</source>
        <translation>Recherche, formation et répétition du geste planifié. Pas un dispositif médical.

Palpate est un logiciel libre sous licence BSD à 3 clauses. Il utilise Qt (LGPL 3), VTK (BSD à 3 clauses), Eigen (MPL 2.0), SQLite (domaine public), hidapi (BSD) et CLI11 (BSD à 3 clauses).</translation>
    </message>
    <message>
        <source>Copy for a report</source>
        <translation>Copier pour un rapport</translation>
    </message>
    <message>
        <source>Copied: version, build and system.</source>
        <translation>Copié&#x202f;: version, build et système.</translation>
    </message>
</context>
<context>
    <name>palpate::app::Language</name>
    <message>
        <source>Language</source>
        <translation>Langue</translation>
    </message>
    <message>
        <source>Palpate speaks another language when it is started again.</source>
        <translation>Palpate changera de langue au prochain démarrage.</translation>
    </message>
    <message>
        <source>As the system</source>
        <translation>Comme le système</translation>
    </message>
</context>
<context>
    <name>palpate::app::ShowAround</name>
    <message>
        <source>Show me around</source>
        <translation>Visite guidée</translation>
    </message>
    <message>
        <source>Four notes on the window, on the practice liver when nothing is open</source>
        <translation>Quatre notes sur la fenêtre, sur le foie d’exercice si rien n’est ouvert</translation>
    </message>
    <message>
        <source>This is a practice liver with lumps inside.</source>
        <translation>Voici un foie d’exercice qui contient des nodules.</translation>
    </message>
    <message>
        <source>Shown on what is open; nothing of it is changed.</source>
        <translation>Montré sur ce qui est ouvert&#x202f;; rien n’en est modifié.</translation>
    </message>
    <message>
        <source>Structures</source>
        <translation>Structures</translation>
    </message>
    <message>
        <source>The list has every structure. The eye shows or hides it, the hand lets you feel it or not; below stands the tissue that it is felt as.</source>
        <translation>La liste contient toutes les structures. L’œil en affiche ou masque une, la main la rend palpable ou non&#x202f;; en dessous figure le tissu comme lequel elle est sentie.</translation>
    </message>
    <message>
        <source>Press to feel</source>
        <translation>Appuyer pour sentir</translation>
    </message>
    <message>
        <source>Press P, then drag on the anatomy: you press and slide, the wheel goes deeper. By keys: Ctrl and the arrows move the place, Enter presses, Page down goes deeper. Esc lets go.</source>
        <translation>Taper P, puis glisser sur l’anatomie&#x202f;: on appuie et on glisse, la molette va plus profond. Au clavier&#x202f;: Ctrl et les flèches déplacent l’endroit, Entrée appuie, Page suivante va plus profond. Échap lâche.</translation>
    </message>
    <message>
        <source>Touch</source>
        <translation>Toucher</translation>
    </message>
    <message>
        <source>The force in newtons, which structure is touched, how deep in millimetres, and the last ten seconds. What is stiffer than its surroundings pushes back more at the same depth.</source>
        <translation>La force en newtons, la structure touchée, la profondeur en millimètres, et les dix dernières secondes. Ce qui est plus raide que son entourage repousse plus fort à la même profondeur.</translation>
    </message>
    <message>
        <source>Record and findings</source>
        <translation>Enregistrement et points repérés</translation>
    </message>
    <message>
        <source>R records what you feel, and again ends it. M marks the place you touch as a finding: it stands here with force and depth; F2 names it. File › Export findings… writes them out.</source>
        <translation>R enregistre ce que vous sentez, et y met fin. M marque l’endroit touché comme point repéré&#x202f;: il figure ici avec force et profondeur&#x202f;; F2 le nomme. Fichier › Exporter les points repérés… les écrit.</translation>
    </message>
</context>
<context>
    <name>palpate::app::SoundChoice</name>
    <message>
        <source>Sound of touch</source>
        <translation>Son du toucher</translation>
    </message>
    <message>
        <source>Hear a tone as high as the place is stiff, as loud as the force</source>
        <translation>Un son d’autant plus aigu que l’endroit est raide, d’autant plus fort que la force est grande</translation>
    </message>
    <message>
        <source>The sound of touch has ended: the loudspeaker is gone.</source>
        <translation>Le son du toucher a cessé&#x202f;: le haut-parleur a disparu.</translation>
    </message>
    <message>
        <source>Sound of touch (%1)</source>
        <translation>Son du toucher (%1)</translation>
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
        <translation>Ce qu’il y a d’autre à dire</translation>
    </message>
    <message>
        <source>What there is no room for in this row</source>
        <translation>Ce qui ne tient pas dans cette ligne</translation>
    </message>
</context>
<context>
    <name>palpate::ui::DeviceChoice</name>
    <message>
        <source>Mouse</source>
        <translation>Souris</translation>
    </message>
    <message>
        <source>The pointer over the view; it feels nothing, the force is shown</source>
        <translation>Le pointeur sur la vue&#x202f;; il ne sent rien, la force est affichée</translation>
    </message>
    <message>
        <source>Simulated hand</source>
        <translation>Main simulée</translation>
    </message>
    <message>
        <source>Palpates what is in the middle of the view, and feels the force</source>
        <translation>Palpe ce qui est au milieu de la vue, et sent la force</translation>
    </message>
    <message>
        <source>Replay with today&apos;s tissue</source>
        <translation>Rejouer avec le tissu d’aujourd’hui</translation>
    </message>
    <message>
        <source>The open recording&apos;s motion, felt with the tissue as it is now</source>
        <translation>Le mouvement de l’enregistrement ouvert, senti avec les tissus actuels</translation>
    </message>
    <message>
        <source>%1 (skipped)</source>
        <translation>%1 (ignoré)</translation>
    </message>
    <message>
        <source>SpaceMouse moves the view</source>
        <translation>SpaceMouse déplace la vue</translation>
    </message>
    <message>
        <source>The puck turns and shifts the anatomy while another device is the hand</source>
        <translation>Le palet tourne et déplace l’anatomie pendant qu’un autre appareil est la main</translation>
    </message>
    <message>
        <source>Calibrate</source>
        <translation>Étalonner</translation>
    </message>
    <message>
        <source>Takes the pose that the device is in now as its calibration pose</source>
        <translation>Prend la position actuelle de l’appareil comme position d’étalonnage</translation>
    </message>
    <message>
        <source>What is plugged in…</source>
        <translation>Ce qui est branché…</translation>
    </message>
    <message>
        <source>mouse</source>
        <translation>souris</translation>
    </message>
    <message>
        <source>simulated hand</source>
        <translation>main simulée</translation>
    </message>
    <message>
        <source>recording, felt anew</source>
        <translation>enregistrement, senti de nouveau</translation>
    </message>
    <message>
        <source>%1 lost</source>
        <translation>%1 perdu</translation>
    </message>
    <message>
        <source>%1: calibrate</source>
        <translation>%1&#x202f;: étalonner</translation>
    </message>
    <message>
        <source>The hand&apos;s device: %1</source>
        <translation>L’appareil de la main&#x202f;: %1</translation>
    </message>
    <message>
        <source>It feels nothing: the force is shown, up to %1 N.</source>
        <translation>Il ne rend rien au toucher&#x202f;: la force est affichée, jusqu’à %1&#xa0;N.</translation>
    </message>
    <message>
        <source>Up to %1 N and %2 N/mm</source>
        <translation>Jusqu’à %1&#xa0;N et %2&#xa0;N/mm</translation>
    </message>
    <message>
        <source>%1: it would need %2.</source>
        <translation>%1&#x202f;: il faudrait %2.</translation>
    </message>
    <message>
        <source>No haptic device and no 6-axis mouse is plugged in.</source>
        <translation>Aucun appareil haptique ni souris à 6 axes n’est branché.</translation>
    </message>
    <message>
        <source>Devices</source>
        <translation>Appareils</translation>
    </message>
    <message>
        <source>SpaceMouse presses</source>
        <translation>La SpaceMouse appuie</translation>
    </message>
    <message>
        <source>The pointer says where, the puck how hard: the further it is pushed down, the more newtons of effort</source>
        <translation>Le pointeur dit où, le palet avec quelle force&#x202f;: plus il est poussé vers le bas, plus il y a de newtons</translation>
    </message>
</context>
<context>
    <name>palpate::ui::EnergyBar</name>
    <message>
        <source>Energy observer</source>
        <translation>Bilan d’énergie</translation>
    </message>
    <message>
        <source>%1 mJ</source>
        <translation>%1&#xa0;mJ</translation>
    </message>
</context>
<context>
    <name>palpate::ui::Engine</name>
    <message>
        <source>the file is empty</source>
        <translation>le fichier est vide</translation>
    </message>
    <message>
        <source>a web page (HTML), perhaps a failed download</source>
        <translation>une page web (HTML), peut-être un téléchargement manqué</translation>
    </message>
    <message>
        <source>the content is no known mesh format</source>
        <translation>le contenu n’est d’aucun format de maillage connu</translation>
    </message>
    <message>
        <source>is %1, which Palpate does not read</source>
        <translation>est %1, que Palpate ne lit pas</translation>
    </message>
    <message>
        <source>a glTF file</source>
        <translation>un fichier glTF</translation>
    </message>
    <message>
        <source>a ZIP archive</source>
        <translation>une archive ZIP</translation>
    </message>
    <message>
        <source>a gzip file</source>
        <translation>un fichier gzip</translation>
    </message>
    <message>
        <source>an NRRD image</source>
        <translation>une image NRRD</translation>
    </message>
    <message>
        <source>a PNG image</source>
        <translation>une image PNG</translation>
    </message>
    <message>
        <source>a PDF document</source>
        <translation>un document PDF</translation>
    </message>
    <message>
        <source>an SQLite database (a recording?)</source>
        <translation>une base de données SQLite (un enregistrement&#x202f;?)</translation>
    </message>
    <message>
        <source>a DICOM file</source>
        <translation>un fichier DICOM</translation>
    </message>
    <message>
        <source>an %1 mesh</source>
        <translation>un maillage %1</translation>
    </message>
    <message>
        <source>an %1 mesh: save it as one of these</source>
        <translation>un maillage %1&#x202f;: l’enregistrer dans un de ces formats</translation>
    </message>
    <message>
        <source>a readable file</source>
        <translation>un fichier lisible</translation>
    </message>
    <message>
        <source>a mesh file</source>
        <translation>un fichier de maillage</translation>
    </message>
    <message>
        <source>is a folder</source>
        <translation>est un dossier</translation>
    </message>
    <message>
        <source>is not a regular file</source>
        <translation>n’est pas un fichier ordinaire</translation>
    </message>
    <message>
        <source>cannot be opened</source>
        <translation>ne peut pas être ouvert</translation>
    </message>
    <message>
        <source>cannot be read</source>
        <translation>ne peut pas être lu</translation>
    </message>
    <message>
        <source>cannot be written</source>
        <translation>ne peut pas être écrit</translation>
    </message>
    <message>
        <source>cannot be written: %1; choose another folder</source>
        <translation>ne peut pas être écrit&#x202f;: %1&#x202f;; choisir un autre dossier</translation>
    </message>
    <message>
        <source>No such file or directory</source>
        <translation>Fichier ou dossier introuvable</translation>
    </message>
    <message>
        <source>Permission denied</source>
        <translation>Permission refusée</translation>
    </message>
    <message>
        <source>Read-only file system</source>
        <translation>Système de fichiers en lecture seule</translation>
    </message>
    <message>
        <source>No space left on device</source>
        <translation>Plus de place sur le disque</translation>
    </message>
    <message>
        <source>Is a directory</source>
        <translation>Est un dossier</translation>
    </message>
    <message>
        <source>the disk is full</source>
        <translation>le disque est plein</translation>
    </message>
    <message>
        <source>no memory to read it</source>
        <translation>pas de mémoire pour le lire</translation>
    </message>
    <message>
        <source>not enough memory to read it</source>
        <translation>pas assez de mémoire pour le lire</translation>
    </message>
    <message>
        <source>a mesh that fits</source>
        <translation>un maillage qui y tient</translation>
    </message>
    <message>
        <source>the file became shorter while it was read</source>
        <translation>le fichier est devenu plus court pendant la lecture</translation>
    </message>
    <message>
        <source>a folder without mesh files</source>
        <translation>un dossier sans fichiers de maillage</translation>
    </message>
    <message>
        <source>%1 files in it</source>
        <translation>%1 fichiers dedans</translation>
    </message>
    <message>
        <source>the folder cannot be read: %1</source>
        <translation>le dossier ne peut pas être lu&#x202f;: %1</translation>
    </message>
    <message>
        <source>a folder of meshes</source>
        <translation>un dossier de maillages</translation>
    </message>
    <message>
        <source>no such file</source>
        <translation>fichier introuvable</translation>
    </message>
    <message>
        <source>none of %1 triangle has an area</source>
        <translation>le seul triangle (%1) n’a pas d’aire</translation>
    </message>
    <message>
        <source>none of %1 triangles has an area</source>
        <translation>aucun des %1 triangles n’a d’aire</translation>
    </message>
    <message>
        <source>at least one that has</source>
        <translation>au moins un qui en ait</translation>
    </message>
    <message>
        <source>at least one</source>
        <translation>au moins un</translation>
    </message>
    <message>
        <source>0 triangles</source>
        <translation>0 triangle</translation>
    </message>
    <message>
        <source>0 faces</source>
        <translation>0 face</translation>
    </message>
    <message>
        <source>0 polygons and strips</source>
        <translation>0 polygone et bande</translation>
    </message>
    <message>
        <source>%1 triangle</source>
        <translation>%1 triangle</translation>
    </message>
    <message>
        <source>%1 triangles</source>
        <translation>%1 triangles</translation>
    </message>
    <message>
        <source>%1 point</source>
        <translation>%1 point</translation>
    </message>
    <message>
        <source>%1 points</source>
        <translation>%1 points</translation>
    </message>
    <message>
        <source>%1 byte</source>
        <translation>%1 octet</translation>
    </message>
    <message>
        <source>%1 bytes</source>
        <translation>%1 octets</translation>
    </message>
    <message>
        <source>%1 whole triangle</source>
        <translation>%1 triangle entier</translation>
    </message>
    <message>
        <source>%1 whole triangles</source>
        <translation>%1 triangles entiers</translation>
    </message>
    <message>
        <source>%1 polygon</source>
        <translation>%1 polygone</translation>
    </message>
    <message>
        <source>%1 polygons</source>
        <translation>%1 polygones</translation>
    </message>
    <message>
        <source>%1 face</source>
        <translation>%1 face</translation>
    </message>
    <message>
        <source>%1 faces</source>
        <translation>%1 faces</translation>
    </message>
    <message>
        <source>%1 corner</source>
        <translation>%1 coin</translation>
    </message>
    <message>
        <source>%1 corners</source>
        <translation>%1 coins</translation>
    </message>
    <message>
        <source>%1 to %2</source>
        <translation>%1 à %2</translation>
    </message>
    <message>
        <source>%1 of %2 have coordinates that are not numbers</source>
        <translation>%1 sur %2 ont des coordonnées qui ne sont pas des nombres</translation>
    </message>
    <message>
        <source>%1 of %2 have coordinates that are farther than 10 km from the origin</source>
        <translation>%1 sur %2 ont des coordonnées à plus de 10&#xa0;km de l’origine</translation>
    </message>
    <message>
        <source>%1 of %2 have coordinates that are not numbers (first: triangle %3)</source>
        <translation>%1 sur %2 ont des coordonnées qui ne sont pas des nombres (premier&#x202f;: triangle %3)</translation>
    </message>
    <message>
        <source>%1 of %2 have coordinates that are farther than 10 km from the origin (first: triangle %3)</source>
        <translation>%1 sur %2 ont des coordonnées à plus de 10&#xa0;km de l’origine (premier&#x202f;: triangle %3)</translation>
    </message>
    <message>
        <source>finite coordinates within 10 km</source>
        <translation>des coordonnées finies à moins de 10&#xa0;km</translation>
    </message>
    <message>
        <source>the file ends in the STL header</source>
        <translation>le fichier finit dans l’en-tête STL</translation>
    </message>
    <message>
        <source>the file ends in the header</source>
        <translation>le fichier finit dans l’en-tête</translation>
    </message>
    <message>
        <source>at least %1 bytes</source>
        <translation>au moins %1 octets</translation>
    </message>
    <message>
        <source>at most %1</source>
        <translation>au plus %1</translation>
    </message>
    <message>
        <source>the binary STL declares %1 but its %2 hold %3</source>
        <translation>le STL binaire annonce %1 mais ses %2 en contiennent %3</translation>
    </message>
    <message>
        <source>the file ends there: %1 of %2 lost</source>
        <translation>le fichier finit là&#x202f;: %1 sur %2 perdus</translation>
    </message>
    <message>
        <source>the file ends after %1</source>
        <translation>le fichier finit après %1</translation>
    </message>
    <message>
        <source>what came after %1 lost</source>
        <translation>ce qui suivait %1 est perdu</translation>
    </message>
    <message>
        <source>the file ends in a line: that line and what came after it lost</source>
        <translation>le fichier finit au milieu d’une ligne&#x202f;: cette ligne et la suite sont perdues</translation>
    </message>
    <message>
        <source>too many elements</source>
        <translation>trop d’éléments</translation>
    </message>
    <message>
        <source>%1 elements declared</source>
        <translation>%1 éléments annoncés</translation>
    </message>
    <message>
        <source>%1 is not a number</source>
        <translation>%1 n’est pas un nombre</translation>
    </message>
    <message>
        <source>three numbers</source>
        <translation>trois nombres</translation>
    </message>
    <message>
        <source>the vertex has fewer than three coordinates</source>
        <translation>le sommet a moins de trois coordonnées</translation>
    </message>
    <message>
        <source>it uses point %1</source>
        <translation>il utilise le point %1</translation>
    </message>
    <message>
        <source>no faces with a list of vertex indices</source>
        <translation>aucune face avec une liste d’indices de sommets</translation>
    </message>
    <message>
        <source>no vertices with x, y and z</source>
        <translation>aucun sommet avec x, y et z</translation>
    </message>
    <message>
        <source>one of each</source>
        <translation>un de chaque</translation>
    </message>
    <message>
        <source>vertex index %1 (%2 vertices so far)</source>
        <translation>indice de sommet %1 (%2 sommets jusque-là)</translation>
    </message>
    <message>
        <source>face %1 uses vertex %2</source>
        <translation>la face %1 utilise le sommet %2</translation>
    </message>
    <message>
        <source>a zero byte</source>
        <translation>un octet nul</translation>
    </message>
    <message>
        <source>text</source>
        <translation>du texte</translation>
    </message>
    <message>
        <source>the end of the line</source>
        <translation>la fin de la ligne</translation>
    </message>
    <message>
        <source>the XML is broken: %1</source>
        <translation>le XML est défectueux&#x202f;: %1</translation>
    </message>
    <message>
        <source>well-formed XML to the end</source>
        <translation>du XML bien formé jusqu’à la fin</translation>
    </message>
    <message>
        <source>its mesh is larger than %1 MiB</source>
        <translation>son maillage dépasse %1&#xa0;MiB</translation>
    </message>
    <message>
        <source>a mesh that fits its file&apos;s size</source>
        <translation>un maillage qui corresponde à la taille du fichier</translation>
    </message>
    <message>
        <source>reading it takes more than %1 MiB of memory</source>
        <translation>sa lecture demande plus de %1&#xa0;MiB de mémoire</translation>
    </message>
    <message>
        <source>reading it took more than %1 s</source>
        <translation>sa lecture a pris plus de %1&#xa0;s</translation>
    </message>
    <message>
        <source>reading it took more than %1 s of processor time</source>
        <translation>sa lecture a pris plus de %1&#xa0;s de temps processeur</translation>
    </message>
    <message>
        <source>a mesh that can be read sooner</source>
        <translation>un maillage qui se lise plus vite</translation>
    </message>
    <message>
        <source>the system ended the process that read it, perhaps for want of memory</source>
        <translation>le système a arrêté le processus qui le lisait, peut-être faute de mémoire</translation>
    </message>
    <message>
        <source>a file that can be read</source>
        <translation>un fichier lisible</translation>
    </message>
    <message>
        <source>no structure %1</source>
        <translation>aucune structure %1</translation>
    </message>
    <message>
        <source>one of that name</source>
        <translation>une de ce nom</translation>
    </message>
    <message>
        <source>%1 open edge: the surface has holes or a rim</source>
        <translation>%1 arête ouverte&#x202f;: la surface a des trous ou un bord</translation>
    </message>
    <message>
        <source>%1 open edges: the surface has holes or a rim</source>
        <translation>%1 arêtes ouvertes&#x202f;: la surface a des trous ou un bord</translation>
    </message>
    <message>
        <source>%1 triangle without area left out</source>
        <translation>%1 triangle sans aire laissé de côté</translation>
    </message>
    <message>
        <source>%1 triangles without area left out</source>
        <translation>%1 triangles sans aire laissés de côté</translation>
    </message>
    <message>
        <source>%1 duplicate triangle left out</source>
        <translation>%1 triangle en double laissé de côté</translation>
    </message>
    <message>
        <source>%1 duplicate triangles left out</source>
        <translation>%1 triangles en double laissés de côté</translation>
    </message>
    <message>
        <source>%1 triangle turned round to face the same way as the rest</source>
        <translation>%1 triangle retourné pour regarder du même côté que les autres</translation>
    </message>
    <message>
        <source>%1 triangles turned round to face the same way as the rest</source>
        <translation>%1 triangles retournés pour regarder du même côté que les autres</translation>
    </message>
    <message>
        <source>%1 edge shared by more than two triangles</source>
        <translation>%1 arête partagée par plus de deux triangles</translation>
    </message>
    <message>
        <source>%1 edges shared by more than two triangles</source>
        <translation>%1 arêtes partagées par plus de deux triangles</translation>
    </message>
    <message>
        <source>%1 part without a consistent front</source>
        <translation>%1 partie sans face avant cohérente</translation>
    </message>
    <message>
        <source>%1 parts without a consistent front</source>
        <translation>%1 parties sans face avant cohérente</translation>
    </message>
    <message>
        <source>%1 part without an inside, touched from both sides</source>
        <translation>%1 partie sans intérieur, touchée des deux côtés</translation>
    </message>
    <message>
        <source>%1 parts without an inside, touched from both sides</source>
        <translation>%1 parties sans intérieur, touchées des deux côtés</translation>
    </message>
    <message>
        <source>%1 values of arrays differed by more than 10 % from another at the same vertex: the mean is used</source>
        <translation>%1 valeurs de tableaux différaient de plus de 10&#x202f;% d’une autre au même sommet&#x202f;: la moyenne est prise</translation>
    </message>
    <message>
        <source>no SPACE tag: coordinates taken as LPS</source>
        <translation>pas d’indication SPACE&#x202f;: coordonnées prises comme LPS</translation>
    </message>
    <message>
        <source>%1 and %2 more file</source>
        <translation>%1 et %2 fichier de plus</translation>
    </message>
    <message>
        <source>%1 and %2 more files</source>
        <translation>%1 et %2 fichiers de plus</translation>
    </message>
    <message>
        <source>tagged SPACE=RAS: x and y negated to get LPS</source>
        <translation>indique SPACE=RAS&#x202f;: x et y changés de signe pour obtenir LPS</translation>
    </message>
    <message>
        <source>tagged SPACE=%1, but taken as %2, as was chosen</source>
        <translation>indique SPACE=%1, mais pris comme %2, ainsi que choisi</translation>
    </message>
    <message>
        <source>taken as %1, as the scene file says; not as %2</source>
        <translation>pris comme %1, ainsi que le dit le fichier de scène&#x202f;; non comme %2</translation>
    </message>
    <message>
        <source>only %1 units wide, taken as %2; looks like %3: open with --unit %4</source>
        <translation>seulement %1 unités de large, pris en %2&#x202f;; semble être en %3&#x202f;: ouvrir avec --unit %4</translation>
    </message>
    <message>
        <source>%1 units wide, taken as %2; looks like %3: open with --unit %4</source>
        <translation>%1 unités de large, pris en %2&#x202f;; semble être en %3&#x202f;: ouvrir avec --unit %4</translation>
    </message>
    <message>
        <source>metres</source>
        <translation>mètres</translation>
    </message>
    <message>
        <source>millimetres</source>
        <translation>millimètres</translation>
    </message>
    <message>
        <source>larger ones</source>
        <translation>plus grandes</translation>
    </message>
    <message>
        <source>%1 and %2 are the same surface twice</source>
        <translation>%1 et %2 sont deux fois la même surface</translation>
    </message>
    <message>
        <source>%1 lies in %2 and is felt below it</source>
        <translation>%1 est dans %2 et se sent dessous</translation>
    </message>
    <message>
        <source>%1 lies in %2, which is felt in the last of %3 layers: both are felt in that one</source>
        <translation>%1 est dans %2, qui se sent dans la dernière des %3 couches&#x202f;: les deux se sentent dans celle-là</translation>
    </message>
    <message>
        <source>%1 seems to lie in %2, whose surface is open or inside out: it is not felt below it</source>
        <translation>%1 semble être dans %2, dont la surface est ouverte ou retournée&#x202f;: il ne se sent pas dessous</translation>
    </message>
    <message>
        <source>colours not read: those of its %1</source>
        <translation>couleurs non lues&#x202f;: celles de ses %1</translation>
    </message>
    <message>
        <source>changed since the scene was saved: found SHA-256 %1, expected %2; opened as it is now</source>
        <translation>changé depuis que la scène a été enregistrée&#x202f;: trouvé SHA-256 %1, attendu %2&#x202f;; ouvert tel qu’il est maintenant</translation>
    </message>
    <message>
        <source>is a list of 3D Slicer marks, not a Palpate scene: open the anatomy, then take the marks in with File &gt; Import findings</source>
        <translation>est une liste de marques de 3D Slicer, non une scène de Palpate&#x202f;: ouvrir l’anatomie, puis reprendre les marques par Fichier &gt; Importer des points repérés</translation>
    </message>
    <message>
        <source>is not a Palpate scene: found neither `version` nor `structures`; expected a file that Palpate saved (.palpate.json)</source>
        <translation>n’est pas une scène de Palpate&#x202f;: ni `version` ni `structures` trouvés&#x202f;; attendu un fichier enregistré par Palpate (.palpate.json)</translation>
    </message>
    <message>
        <source>version: found %1, expected at most %2: it was made by a newer Palpate</source>
        <translation>version&#x202f;: trouvé %1, attendu au plus %2&#x202f;: elle vient d’un Palpate plus récent</translation>
    </message>
    <message>
        <source>no JSON object</source>
        <translation>aucun objet JSON</translation>
    </message>
    <message>
        <source>a scene as a JSON object</source>
        <translation>une scène comme objet JSON</translation>
    </message>
    <message>
        <source>an array</source>
        <translation>un tableau</translation>
    </message>
    <message>
        <source>an object</source>
        <translation>un objet</translation>
    </message>
    <message>
        <source>a text</source>
        <translation>un texte</translation>
    </message>
    <message>
        <source>a number</source>
        <translation>un nombre</translation>
    </message>
    <message>
        <source>true or false</source>
        <translation>vrai ou faux</translation>
    </message>
    <message>
        <source>an array of %1</source>
        <translation>un tableau de %1</translation>
    </message>
    <message>
        <source>%1 numbers</source>
        <translation>%1 nombres</translation>
    </message>
    <message>
        <source>a whole number</source>
        <translation>un nombre entier</translation>
    </message>
    <message>
        <source>a fraction</source>
        <translation>une fraction</translation>
    </message>
    <message>
        <source>nothing</source>
        <translation>rien</translation>
    </message>
    <message>
        <source>none</source>
        <translation>aucun</translation>
    </message>
    <message>
        <source>the path of a mesh file</source>
        <translation>le chemin d’un maillage</translation>
    </message>
    <message>
        <source>the path of a recording</source>
        <translation>le chemin d’un enregistrement</translation>
    </message>
    <message>
        <source>the name of a structure of this scene</source>
        <translation>le nom d’une structure de cette scène</translation>
    </message>
    <message>
        <source>one of %1</source>
        <translation>un de %1</translation>
    </message>
    <message>
        <source>no such file, expected a recording</source>
        <translation>fichier introuvable, attendu un enregistrement</translation>
    </message>
    <message>
        <source>found no SQLite database, expected a recording</source>
        <translation>trouvé autre chose qu’une base SQLite, attendu un enregistrement</translation>
    </message>
    <message>
        <source>found another program&apos;s SQLite database, expected a Palpate recording</source>
        <translation>trouvé la base SQLite d’un autre programme, attendu un enregistrement de Palpate</translation>
    </message>
    <message>
        <source>found a recording of version %1, expected at most %2: a newer Palpate made it</source>
        <translation>trouvé un enregistrement de version %1, attendu au plus %2&#x202f;: fait par un Palpate plus récent</translation>
    </message>
    <message>
        <source>found no tick with a hand, expected at least one</source>
        <translation>aucun instant avec une main, attendu au moins un</translation>
    </message>
    <message>
        <source>damaged: %1</source>
        <translation>endommagé&#x202f;: %1</translation>
    </message>
    <message>
        <source>file is not a database</source>
        <translation>le fichier n’est pas une base de données</translation>
    </message>
    <message>
        <source>database disk image is malformed</source>
        <translation>l’image disque de la base est mal formée</translation>
    </message>
    <message>
        <source>unable to open database file</source>
        <translation>impossible d’ouvrir le fichier de la base</translation>
    </message>
    <message>
        <source>database or disk is full</source>
        <translation>la base ou le disque est plein</translation>
    </message>
    <message>
        <source>attempt to write a readonly database</source>
        <translation>tentative d’écriture dans une base en lecture seule</translation>
    </message>
    <message>
        <source>disk I/O error</source>
        <translation>erreur d’entrée-sortie du disque</translation>
    </message>
    <message>
        <source>the recording ended at %1 s because %2; what was felt after is not in it</source>
        <translation>l’enregistrement a fini à %1&#xa0;s car %2&#x202f;; ce qui a été senti ensuite n’y est pas</translation>
    </message>
    <message>
        <source>nothing was recorded because %1</source>
        <translation>rien n’a été enregistré car %1</translation>
    </message>
    <message>
        <source>the disk cannot be written (%1)</source>
        <translation>le disque ne peut pas être écrit (%1)</translation>
    </message>
    <message>
        <source>ended at %1 s because the disk was full; what was felt after is not in it</source>
        <translation>fini à %1&#xa0;s car le disque était plein&#x202f;; ce qui a été senti ensuite n’y est pas</translation>
    </message>
    <message>
        <source>ended at %1 s because the disk could not be written; what was felt after is not in it</source>
        <translation>fini à %1&#xa0;s car le disque ne pouvait pas être écrit&#x202f;; ce qui a été senti ensuite n’y est pas</translation>
    </message>
    <message>
        <source>ended at %1 s without being closed (a crash, or a full disk); what was felt after is not in it</source>
        <translation>fini à %1&#xa0;s sans être fermé (un arrêt brutal ou un disque plein)&#x202f;; ce qui a été senti ensuite n’y est pas</translation>
    </message>
    <message>
        <source>%1 ticks were lost</source>
        <translation>%1 instants ont été perdus</translation>
    </message>
    <message>
        <source>cannot be recorded: the servo loop is not running</source>
        <translation>impossible d’enregistrer&#x202f;: la boucle d’asservissement ne tourne pas</translation>
    </message>
    <message>
        <source>cannot be recorded: the servo loop does not answer</source>
        <translation>impossible d’enregistrer&#x202f;: la boucle d’asservissement ne répond pas</translation>
    </message>
    <message>
        <source>found none of the surfaces that it was made on</source>
        <translation>aucune des surfaces sur lesquelles il a été fait n’a été trouvée</translation>
    </message>
    <message>
        <source>it holds none and names no mesh</source>
        <translation>il n’en contient aucune et ne nomme aucun maillage</translation>
    </message>
    <message>
        <source>no such file, neither where it was nor beside the recording</source>
        <translation>fichier introuvable, ni là où il était ni à côté de l’enregistrement</translation>
    </message>
    <message>
        <source>is another surface now than was recorded; opened as it is now</source>
        <translation>est maintenant une autre surface que celle enregistrée&#x202f;; ouverte telle qu’elle est</translation>
    </message>
    <message>
        <source>its recorded map is of another surface; it is not felt</source>
        <translation>sa carte enregistrée est celle d’une autre surface&#x202f;; elle ne se sent pas</translation>
    </message>
    <message>
        <source>what lumps below it made is of another surface; it is not felt</source>
        <translation>ce que les nodules dessous en faisaient est d’une autre surface&#x202f;; cela ne se sent pas</translation>
    </message>
    <message>
        <source>the recording does not say what scene it was made on</source>
        <translation>l’enregistrement ne dit pas sur quelle scène il a été fait</translation>
    </message>
    <message>
        <source>rate and CPU cannot be changed while a recording runs; stop it first</source>
        <translation>fréquence et CPU ne changent pas pendant un enregistrement&#x202f;; l’arrêter d’abord</translation>
    </message>
    <message>
        <source>the device cannot be changed while a recording runs; stop it first</source>
        <translation>l’appareil ne change pas pendant un enregistrement&#x202f;; l’arrêter d’abord</translation>
    </message>
    <message>
        <source>the SpaceMouse is the hand now; choose another device for it first</source>
        <translation>la SpaceMouse est la main&#x202f;; choisir d’abord un autre appareil pour celle-ci</translation>
    </message>
    <message>
        <source>no device is called %1</source>
        <translation>aucun appareil ne s’appelle %1</translation>
    </message>
    <message>
        <source>the simulated hand palpates what is in the middle of the view: found nothing palpable there</source>
        <translation>la main simulée palpe ce qui est au milieu de la vue&#x202f;: rien de palpable trouvé là</translation>
    </message>
    <message>
        <source>no recording is open whose motion could be felt anew</source>
        <translation>aucun enregistrement ouvert dont le mouvement puisse être ressenti à nouveau</translation>
    </message>
    <message>
        <source>the motion to play has no rows</source>
        <translation>le mouvement à rejouer n’a pas de lignes</translation>
    </message>
    <message>
        <source>the device could not be started: %1</source>
        <translation>l’appareil n’a pas pu démarrer&#x202f;: %1</translation>
    </message>
    <message>
        <source>its driver failed</source>
        <translation>son pilote a échoué</translation>
    </message>
    <message>
        <source>skipped, it hung when it was started</source>
        <translation>ignoré, il s’est bloqué au démarrage</translation>
    </message>
    <message>
        <source>skipped, it ended the process when it was started</source>
        <translation>ignoré, il a arrêté le processus au démarrage</translation>
    </message>
    <message>
        <source>skipped, it failed when it was started</source>
        <translation>ignoré, il a échoué au démarrage</translation>
    </message>
    <message>
        <source>skipped, %1 comes first</source>
        <translation>ignoré, %1 passe avant</translation>
    </message>
    <message>
        <source>CPU %1: this machine has no such CPU</source>
        <translation>CPU %1&#x202f;: cette machine n’a pas ce CPU</translation>
    </message>
    <message>
        <source>The device gave a position that is not a number. Check its driver, then re-arm.</source>
        <translation>L’appareil a donné une position qui n’est pas un nombre. Vérifier son pilote, puis réarmer.</translation>
    </message>
    <message>
        <source>The device gave positions outside its workspace. Calibrate it, then re-arm.</source>
        <translation>L’appareil a donné des positions hors de son espace de travail. Le calibrer, puis réarmer.</translation>
    </message>
    <message>
        <source>The device&apos;s position jumped farther than a hand can move. Check its cable and calibration, then re-arm.</source>
        <translation>La position de l’appareil a sauté plus loin qu’une main ne peut aller. Vérifier câble et calibrage, puis réarmer.</translation>
    </message>
    <message>
        <source>The device stopped giving new positions. Check its connection, then re-arm.</source>
        <translation>L’appareil ne donne plus de nouvelles positions. Vérifier sa connexion, puis réarmer.</translation>
    </message>
    <message>
        <source>The device no longer answers. Plug it in again, then re-arm.</source>
        <translation>L’appareil ne répond plus. Le rebrancher, puis réarmer.</translation>
    </message>
    <message>
        <source>The model gave a force that is not a number. Leave the surface, then re-arm.</source>
        <translation>Le modèle a donné une force qui n’est pas un nombre. Quitter la surface, puis réarmer.</translation>
    </message>
    <message>
        <source>The computer could not keep the servo rate. Close other programs or lower the rate, then re-arm.</source>
        <translation>L’ordinateur n’a pas pu tenir la fréquence. Fermer d’autres programmes ou baisser la fréquence, puis réarmer.</translation>
    </message>
    <message>
        <source>The servo thread ended by an error. Start the device again.</source>
        <translation>La boucle d’asservissement a fini par une erreur. Redémarrer l’appareil.</translation>
    </message>
    <message>
        <source>lumps felt through their organ: %1</source>
        <translation>nodules sentis à travers leur organe&#x202f;: %1</translation>
    </message>
    <message>
        <source>it has %1 points; expected 2 to %2</source>
        <translation>il a %1 points&#x202f;; attendu 2 à %2</translation>
    </message>
    <message>
        <source>it has more points; expected 2 to %1</source>
        <translation>il a plus de points&#x202f;; attendu 2 à %1</translation>
    </message>
    <message>
        <source>left out, its surface is open: it has no volume to be felt</source>
        <translation>laissé de côté, sa surface est ouverte&#x202f;: il n’a pas de volume à sentir</translation>
    </message>
    <message>
        <source>left out, its surface is inside out</source>
        <translation>laissé de côté, sa surface est retournée</translation>
    </message>
    <message>
        <source>left out, it lies outside %1</source>
        <translation>laissé de côté, il est hors de %1</translation>
    </message>
    <message>
        <source>%1 and %2 reach into each other: where both are felt is not judged</source>
        <translation>%1 et %2&#xa0;s’interpénètrent&#x202f;: là où les deux se sentent, rien n’est jugé</translation>
    </message>
    <message>
        <source>%1 was read as %2</source>
        <translation>%1 a été lu comme %2</translation>
    </message>
    <message>
        <source>%1 or %2</source>
        <translation>%1 ou %2</translation>
    </message>
    <message>
        <source>line %1</source>
        <translation>ligne %1</translation>
    </message>
    <message>
        <source>byte %1</source>
        <translation>octet %1</translation>
    </message>
    <message>
        <source>polygon %1</source>
        <translation>polygone %1</translation>
    </message>
    <message>
        <source>point %1</source>
        <translation>point %1</translation>
    </message>
    <message>
        <source>header</source>
        <translation>en-tête</translation>
    </message>
    <message>
        <source>structures</source>
        <translation>structures</translation>
    </message>
    <message>
        <source>%1; expected %2</source>
        <translation>%1&#x202f;; attendu %2</translation>
    </message>
    <message>
        <source>found %1, expected %2</source>
        <translation>trouvé %1, attendu %2</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1&#x202f;: %2</translation>
    </message>
    <message>
        <source>%1 (in English)</source>
        <extracomment>around a line that has no translation</extracomment>
        <translation>%1 (en anglais)</translation>
    </message>
    <message>
        <source>the SpaceMouse moves the view or presses; switch that off first</source>
        <translation>la SpaceMouse déplace la vue ou appuie&#x202f;; désactivez d’abord cela</translation>
    </message>
    <message>
        <source>its triangles are wider than a finger&apos;s contact: what the hand feels of its lumps differs by up to %1 % from what is shown; a finer mesh mends it</source>
        <translation>ses triangles sont plus larges que le contact d’un doigt&#x202f;: ce que la main sent de ses nodules diffère de %1&#xa0;% au plus de ce qui est montré&#x202f;; un maillage plus fin y remédie</translation>
    </message>
    <message>
        <source>its volume is larger than %1 MiB</source>
        <translation>son volume dépasse %1 Mio</translation>
    </message>
    <message>
        <source>a volume that fits its file&apos;s size</source>
        <translation>un volume qui correspond à la taille de son fichier</translation>
    </message>
    <message>
        <source>a volume that fits</source>
        <translation>un volume qui y tient</translation>
    </message>
    <message>
        <source>a volume that can be read sooner</source>
        <translation>un volume qui se lit plus vite</translation>
    </message>
    <message>
        <source>the process that read it gave up (exit code %1)</source>
        <translation>le processus qui le lisait a abandonné (code de retour %1)</translation>
    </message>
    <message>
        <source>reading was cancelled</source>
        <translation>la lecture a été annulée</translation>
    </message>
    <message>
        <source>a volume</source>
        <translation>un volume</translation>
    </message>
    <message>
        <source>a readable volume</source>
        <translation>un volume lisible</translation>
    </message>
    <message>
        <source>it does not end</source>
        <translation>il ne se termine pas</translation>
    </message>
    <message>
        <source>a header that says where the voxels are</source>
        <translation>un en-tête qui dit où sont les voxels</translation>
    </message>
    <message>
        <source>it does not end with its last tag</source>
        <translation>il ne se termine pas par sa dernière balise</translation>
    </message>
    <message>
        <source>`&lt;/VTKFile&gt;` at the end</source>
        <translation>`&lt;/VTKFile&gt;` à la fin</translation>
    </message>
    <message>
        <source>its compressed voxels are cut off or broken</source>
        <translation>ses voxels compressés sont tronqués ou endommagés</translation>
    </message>
    <message>
        <source>%1 bytes when unpacked</source>
        <translation>%1 octets une fois décompressés</translation>
    </message>
    <message>
        <source>%1 bytes of voxels</source>
        <translation>%1 octets de voxels</translation>
    </message>
    <message>
        <source>%1 voxels declared</source>
        <translation>%1 voxels annoncés</translation>
    </message>
    <message>
        <source>as many as its %1 bytes can hold</source>
        <translation>autant que ses %1 octets peuvent en contenir</translation>
    </message>
    <message>
        <source>an axis without a voxel</source>
        <translation>un axe sans voxel</translation>
    </message>
    <message>
        <source>at least one along each axis</source>
        <translation>au moins un le long de chaque axe</translation>
    </message>
    <message>
        <source>%1 components a voxel</source>
        <translation>%1 composantes par voxel</translation>
    </message>
    <message>
        <source>no numbers</source>
        <translation>aucun nombre</translation>
    </message>
    <message>
        <source>one number for each voxel</source>
        <translation>un nombre pour chaque voxel</translation>
    </message>
    <message>
        <source>axes or distances of its voxels that say no place</source>
        <translation>des axes ou des distances de voxels qui ne donnent aucun lieu</translation>
    </message>
    <message>
        <source>three directions that are not in a plane, and distances that are not 0</source>
        <translation>trois directions qui ne sont pas dans un plan, et des distances non nulles</translation>
    </message>
    <message>
        <source>directions of its axes that can&apos;t be read</source>
        <translation>des directions d’axes illisibles</translation>
    </message>
    <message>
        <source>three vectors that are not in a plane</source>
        <translation>trois vecteurs qui ne sont pas dans un plan</translation>
    </message>
    <message>
        <source>voxels in another encoding</source>
        <translation>des voxels dans un autre codage</translation>
    </message>
    <message>
        <source>`raw` or `gzip`</source>
        <translation>`raw` ou `gzip`</translation>
    </message>
    <message>
        <source>the process that read it crashed (%1)</source>
        <translation>le processus qui le lisait s’est arrêté brutalement (%1)</translation>
    </message>
    <message>
        <source>%1 twice</source>
        <translation>%1 deux fois</translation>
    </message>
    <message>
        <source>each field once</source>
        <translation>chaque champ une fois</translation>
    </message>
    <message>
        <source>no dimension before them</source>
        <translation>aucune dimension avant elles</translation>
    </message>
    <message>
        <source>a dimension</source>
        <translation>une dimension</translation>
    </message>
    <message>
        <source>three counts of voxels</source>
        <translation>trois nombres de voxels</translation>
    </message>
    <message>
        <source>the name of one file</source>
        <translation>le nom d’un seul fichier</translation>
    </message>
    <message>
        <source>no header of NIfTI</source>
        <translation>pas d’en-tête NIfTI</translation>
    </message>
    <message>
        <source>348 or 540 bytes of it</source>
        <translation>348 ou 540 octets d’en-tête</translation>
    </message>
    <message>
        <source>voxels of kind %1</source>
        <translation>des voxels de type %1</translation>
    </message>
    <message>
        <source>one of NIfTI&apos;s kinds, as 16 for float</source>
        <translation>un des types de NIfTI, comme 16 pour float</translation>
    </message>
    <message>
        <source>%1 axes</source>
        <translation>%1 axes</translation>
    </message>
    <message>
        <source>1 to 7</source>
        <translation>1 à 7</translation>
    </message>
    <message>
        <source>a byte of 0 in its text</source>
        <translation>un octet 0 dans son texte</translation>
    </message>
    <message>
        <source>a header of text alone</source>
        <translation>un en-tête fait de texte seul</translation>
    </message>
    <message>
        <source>what is not one number</source>
        <translation>ce qui n’est pas un seul nombre</translation>
    </message>
    <message>
        <source>%1 dimension</source>
        <translation>%1 dimension</translation>
    </message>
    <message>
        <source>%1 dimensions</source>
        <translation>%1 dimensions</translation>
    </message>
    <message>
        <source>1 to 4</source>
        <translation>1 à 4</translation>
    </message>
    <message>
        <source>value %1 is %2</source>
        <translation>la valeur %1 est %2</translation>
    </message>
    <message>
        <source>a number that an Int32 can hold</source>
        <translation>un nombre qu’un Int32 peut contenir</translation>
    </message>
    <message>
        <source>a number that a %1 can hold</source>
        <translation>un nombre qu’un %1 peut contenir</translation>
    </message>
    <message>
        <source>a blank or a new line behind it</source>
        <translation>une espace ou une nouvelle ligne après</translation>
    </message>
    <message>
        <source>%1: %2: this version does not know this field; it is kept, but not used</source>
        <translation>%1&#x202f;: %2&#x202f;: ce champ est inconnu de cette version&#x202f;; il est conservé, mais pas utilisé</translation>
    </message>
    <message>
        <source>File too large</source>
        <translation>Fichier trop volumineux</translation>
    </message>
    <message>
        <source>Disk quota exceeded</source>
        <translation>Quota disque dépassé</translation>
    </message>
    <message>
        <source>Input/output error</source>
        <translation>Erreur d’entrée/sortie</translation>
    </message>
    <message>
        <source>Not a directory</source>
        <translation>N’est pas un dossier</translation>
    </message>
    <message>
        <source>File name too long</source>
        <translation>Nom de fichier trop long</translation>
    </message>
    <message>
        <source>not a file</source>
        <translation>n’est pas un fichier</translation>
    </message>
    <message>
        <source>there is a file of this name; choose another name</source>
        <translation>un fichier de ce nom existe&#x202f;; choisissez un autre nom</translation>
    </message>
    <message>
        <source>another program is recording into it; choose another name</source>
        <translation>un autre programme y enregistre&#x202f;; choisissez un autre nom</translation>
    </message>
    <message>
        <source>the file %1 would be taken for a part of it; move that away or choose another name</source>
        <translation>le fichier %1 serait pris pour une partie de celui-ci&#x202f;; déplacez-le ou choisissez un autre nom</translation>
    </message>
    <message>
        <source>it as input and output</source>
        <translation>le même comme entrée et sortie</translation>
    </message>
    <message>
        <source>it as output and a file of %1</source>
        <translation>le même comme sortie et fichier de %1</translation>
    </message>
    <message>
        <source>another name for the output</source>
        <translation>un autre nom pour la sortie</translation>
    </message>
    <message>
        <source>the touched surface goes there; found another file, expected none or an older export. Choose another name</source>
        <translation>la surface touchée va là&#x202f;; un autre fichier s’y trouve, aucun ou un export antérieur était attendu. Choisissez un autre nom</translation>
    </message>
    <message>
        <source>%1 closed part looks inside out: touched from within only, unless turned outwards</source>
        <translation>%1 partie fermée semble à l’envers&#x202f;: touchée de l’intérieur seulement, sauf si elle est retournée</translation>
    </message>
    <message>
        <source>%1 closed parts look inside out: touched from within only, unless turned outwards</source>
        <translation>%1 parties fermées semblent à l’envers&#x202f;: touchées de l’intérieur seulement, sauf si elles sont retournées</translation>
    </message>
    <message>
        <source>staircase of about %1 × %2 × %3 mm voxels (%4 % of the area in %5 directions)</source>
        <translation>escalier de voxels d’environ %1 × %2 × %3 mm (%4 % de l’aire dans %5 directions)</translation>
    </message>
    <message>
        <source>smoothed: vertices moved by at most %1 mm, volume %2 %</source>
        <translation>lissée&#x202f;: sommets déplacés de %1 mm au plus, volume %2 %</translation>
    </message>
    <message>
        <source>smoothed: vertices moved by at most %1 mm</source>
        <translation>lissée&#x202f;: sommets déplacés de %1 mm au plus</translation>
    </message>
    <message>
        <source>surface &quot;smooth&quot;: curved facets are not available in this version; felt and drawn as facets</source>
        <translation>surface «&#x202f;smooth&#x202f;»&#x202f;: les facettes courbes n’existent pas dans cette version&#x202f;; sentie et dessinée en facettes</translation>
    </message>
    <message>
        <source>%1 and %2 come within %3 mm of each other at (%4, %5, %6) without touching: a point falls into the gap, a fingertip of 0.5 mm or more rides over it</source>
        <translation>%1 et %2 s’approchent à %3 mm en (%4, %5, %6) sans se toucher&#x202f;: un point tombe dans l’interstice, un bout de doigt de 0,5 mm ou plus passe dessus</translation>
    </message>
    <message>
        <source>found the journal of several databases, which names another file to be deleted; Palpate writes none, so this was not made by Palpate; nothing was opened. Move it away to read the recording as it is</source>
        <translation>le journal de plusieurs bases, qui nomme un autre fichier à supprimer&#x202f;; Palpate n’en écrit pas, il ne vient donc pas de Palpate&#x202f;; rien n’a été ouvert. Déplacez-le pour lire l’enregistrement tel quel</translation>
    </message>
    <message>
        <source>found something else than a file, expected the journal of a recording; nothing was opened. Move it away to read the recording as it is</source>
        <translation>autre chose qu’un fichier, le journal d’un enregistrement était attendu&#x202f;; rien n’a été ouvert. Déplacez-le pour lire l’enregistrement tel quel</translation>
    </message>
    <message>
        <source>found a database with a write-ahead log, expected one with a rollback journal, as Palpate writes it: another program changed it</source>
        <translation>une base à journal anticipé (WAL), une base à journal de retour était attendue, comme Palpate l’écrit&#x202f;: un autre programme l’a modifiée</translation>
    </message>
    <message>
        <source>found %1, expected %2: not made by Palpate, or damaged (palpate session recover gathers what is whole)</source>
        <translation>trouvé&#x202f;: %1, attendu&#x202f;: %2&#x202f;: pas créé par Palpate, ou endommagé (palpate session recover rassemble ce qui est intact)</translation>
    </message>
    <message>
        <source>how many times as stiff as %1 it is, is not known, so no verdict is given; expected a ratio, as --ratio &quot;%2=R&quot; or `young_ratio` in a scene file. Published: %3</source>
        <translation>combien de fois il est plus rigide que %1 est inconnu, donc aucun verdict&#x202f;; un rapport est attendu, par --ratio &quot;%2=R&quot; ou `young_ratio` dans un fichier de scène. Publié&#x202f;: %3</translation>
    </message>
    <message>
        <source>%1 and %2 touch in one layer and differ %3-fold in stiffness: the force steps at the seam</source>
        <translation>%1 et %2 se touchent dans une même couche et leurs rigidités diffèrent d’un facteur %3&#x202f;: la force fait un saut à la jonction</translation>
    </message>
</context>
<context>
    <name>palpate::ui::EngineeringPanel</name>
    <message>
        <source>%1 µs</source>
        <translation>%1&#xa0;µs</translation>
    </message>
    <message>
        <source>%1 ms</source>
        <translation>%1&#xa0;ms</translation>
    </message>
    <message>
        <source>half below %1, 99 % below %2</source>
        <translation>la moitié sous %1, 99&#x202f;% sous %2</translation>
    </message>
    <message>
        <source>%1, %2 refused, lost %3 times</source>
        <translation>%1, %2 refusés, perdu %3 fois</translation>
    </message>
    <message>
        <source>Click for the details (View › Engineering).</source>
        <translation>Cliquer pour les détails (Affichage › Technique).</translation>
    </message>
    <message>
        <source>computer too busy</source>
        <translation>ordinateur surchargé</translation>
    </message>
    <message>
        <source>Touch is computed %1 times a second instead of %2: forces may stutter. Close other programs.</source>
        <translation>Le toucher est calculé %1 fois par seconde au lieu de %2&#x202f;: la force peut saccader. Fermez d’autres programmes.</translation>
    </message>
    <message>
        <source>force may stutter</source>
        <translation>la force peut saccader</translation>
    </message>
    <message>
        <source>The system does not give touch its time first: other programs may make the force stutter. The list of messages (F4) says how to permit it.</source>
        <translation>Le système ne sert pas le toucher en premier&#x202f;: d’autres programmes peuvent faire saccader la force. La liste des messages (F4) dit comment le permettre.</translation>
    </message>
    <message>
        <source>running well</source>
        <translation>marche bien</translation>
    </message>
    <message>
        <source>Touch is computed %1 times a second, as it should be.</source>
        <translation>Le toucher est calculé %1 fois par seconde, comme il se doit.</translation>
    </message>
    <message>
        <source>Energy observer: what the hand has put into the touched tissue and not got back [mJ].
Below zero the program would give more than it took; damping then takes it away.</source>
        <translation>Bilan d’énergie&#x202f;: ce que la main a mis dans le tissu touché sans le récupérer [mJ].
Sous zéro, le programme donnerait plus qu’il n’a pris&#x202f;; l’amortissement le retire alors.</translation>
    </message>
    <message>
        <source>What the servo thread was granted</source>
        <translation>Ce qui a été accordé au fil servo</translation>
    </message>
    <message>
        <source>Constraints</source>
        <translation>Contraintes</translation>
    </message>
    <message>
        <source>Active constraints: planes of the surface that hold the hand back, at most 3</source>
        <translation>Contraintes actives&#x202f;: plans de la surface qui retiennent la main, 3 au plus</translation>
    </message>
    <message>
        <source>Solver</source>
        <translation>Solveur</translation>
    </message>
    <message>
        <source>Time of one tick in the solver, of ticks with a hand</source>
        <translation>Durée d’un pas dans le solveur, des pas avec une main</translation>
    </message>
    <message>
        <source>Measured rate</source>
        <translation>Cadence mesurée</translation>
    </message>
    <message>
        <source>Ticks of the servo thread a second, over the last half second [kHz]</source>
        <translation>Pas du fil servo par seconde, sur la dernière demi-seconde [kHz]</translation>
    </message>
    <message>
        <source>Jitter</source>
        <translation>Gigue</translation>
    </message>
    <message>
        <source>How far the time from tick to tick is from the period; 99.9 % of the ticks stay below</source>
        <translation>Écart du temps entre deux pas à la période&#x202f;; 99,9&#x202f;% des pas restent en dessous</translation>
    </message>
    <message>
        <source>Late ticks</source>
        <translation>Pas en retard</translation>
    </message>
    <message>
        <source>Ticks that ended after their time, of all since the loop began; periods left out for it</source>
        <translation>Pas finis après leur temps, sur tous depuis le début de la boucle&#x202f;; périodes sautées pour cela</translation>
    </message>
    <message>
        <source>Dropped ticks</source>
        <translation>Pas perdus</translation>
    </message>
    <message>
        <source>Ticks that were felt but are not in this recording, because the disk was slow</source>
        <translation>Pas sentis mais absents de cet enregistrement, le disque étant lent</translation>
    </message>
    <message>
        <source>Energy</source>
        <translation>Énergie</translation>
    </message>
    <message>
        <source>Energy observer: what the hand has put into the touched tissue and not got back [mJ]</source>
        <translation>Observateur d’énergie&#x202f;: ce que la main a mis dans le tissu touché sans le récupérer [mJ]</translation>
    </message>
    <message>
        <source>Damping added</source>
        <translation>Amortissement ajouté</translation>
    </message>
    <message>
        <source>Force that the passivity controller adds against the movement [N]</source>
        <translation>Force que le contrôleur de passivité ajoute contre le mouvement [N]</translation>
    </message>
    <message>
        <source>Device round trip</source>
        <translation>Aller-retour de l’appareil</translation>
    </message>
    <message>
        <source>From a report of the device received to the force that answers it written</source>
        <translation>De la réception d’un rapport de l’appareil à l’écriture de la force qui y répond</translation>
    </message>
    <message>
        <source>Delay</source>
        <translation>Retard</translation>
    </message>
    <message>
        <source>After which the force is taken to act: it bounds the stiffness that is stable</source>
        <translation>Après lequel la force est censée agir&#x202f;: il borne la raideur stable</translation>
    </message>
    <message>
        <source>Device reports</source>
        <translation>Rapports de l’appareil</translation>
    </message>
    <message>
        <source>Received, of those not to be believed, and how often the device was lost</source>
        <translation>Reçus, dont non crédibles, et combien de fois l’appareil a été perdu</translation>
    </message>
    <message>
        <source>%1 kHz</source>
        <translation>%1&#xa0;kHz</translation>
    </message>
    <message>
        <source>Rate of the servo loop</source>
        <translation>Cadence de la boucle</translation>
    </message>
    <message>
        <source>Ticks a second. A faster loop holds stiffer tissue where the device keeps up; see the jitter.</source>
        <translation>Pas par seconde. Une boucle plus rapide tient un tissu plus raide si l’appareil suit&#x202f;; voir la gigue.</translation>
    </message>
    <message>
        <source>Servo rate</source>
        <translation>Cadence servo</translation>
    </message>
    <message>
        <source>Any</source>
        <translation>Libre</translation>
    </message>
    <message>
        <source>CPU %1 alone</source>
        <translation>CPU %1 seul</translation>
    </message>
    <message>
        <source>CPU of the servo loop</source>
        <translation>CPU de la boucle</translation>
    </message>
    <message>
        <source>Where the servo loop runs. One CPU alone helps where it is kept free of everything else; elsewhere &quot;Any&quot; lets
the loop go where there is room.</source>
        <translation>Où tourne la boucle d’asservissement. Un CPU seul aide s’il est gardé libre de tout le reste&#x202f;; sinon «&#x202f;Libre&#x202f;»
laisse la boucle aller où il y a de la place.</translation>
    </message>
    <message>
        <source>Servo CPU</source>
        <translation>CPU</translation>
    </message>
    <message>
        <source>99.9 % below %1</source>
        <translation>99,9&#x202f;% sous %1</translation>
    </message>
    <message>
        <source>%1 of %2, %3 left out</source>
        <translation>%1 sur %2, sautés&#x202f;: %3</translation>
    </message>
    <message>
        <source>%1 mJ</source>
        <translation>%1&#xa0;mJ</translation>
    </message>
    <message>
        <source>%1 N</source>
        <translation>%1&#xa0;N</translation>
    </message>
</context>
<context>
    <name>palpate::ui::FeltOverlay</name>
    <message>
        <source>pressed %1 mm</source>
        <translation>en appuyant de %1&#xa0;mm</translation>
    </message>
    <message>
        <source>touched lightly</source>
        <translation>touché légèrement</translation>
    </message>
    <message>
        <source>Felt when %1
(estimate)</source>
        <translation>Palpable, %1
(estimation)</translation>
    </message>
    <message>
        <source>not judged</source>
        <translation>non jugé</translation>
    </message>
    <message>
        <source>0 %: no lump</source>
        <translation>0&#x202f;%&#x202f;: aucun nodule</translation>
    </message>
    <message>
        <source>7 %: half of that</source>
        <translation>7&#x202f;%&#x202f;: la moitié de cela</translation>
    </message>
    <message>
        <source>14 %: a trained hand tells</source>
        <translation>14&#x202f;%&#x202f;: une main exercée le sent</translation>
    </message>
    <message>
        <source>28 %: plainly felt</source>
        <translation>28&#x202f;%&#x202f;: nettement senti</translation>
    </message>
    <message>
        <source>%1 %: most here</source>
        <translation>%1&#x202f;%&#x202f;: le plus ici</translation>
    </message>
</context>
<context>
    <name>palpate::ui::FeltPanel</name>
    <message>
        <source>Estimate for research and rehearsal.</source>
        <translation>Estimation pour la recherche et la répétition.</translation>
    </message>
    <message>
        <source>Lump</source>
        <translation>Nodule</translation>
    </message>
    <message>
        <source>Times as stiff</source>
        <translation>Rapport de raideur</translation>
    </message>
    <message>
        <source>Least cover</source>
        <translation>Moindre épaisseur</translation>
    </message>
    <message>
        <source>Pressed %1 mm</source>
        <translation>Appuyé de %1&#xa0;mm</translation>
    </message>
    <message>
        <source>Touched lightly</source>
        <translation>Touché légèrement</translation>
    </message>
    <message>
        <source>Lumps and whether a hand finds them</source>
        <translation>Les nodules, et si une main les trouve</translation>
    </message>
    <message>
        <source>How deep the finger is pressed in</source>
        <translation>De combien le doigt est enfoncé</translation>
    </message>
    <message>
        <source>Coloured as pressed %1 mm</source>
        <translation>Coloré pour un appui de %1&#xa0;mm</translation>
    </message>
    <message>
        <source>Coloured as touched lightly</source>
        <translation>Coloré pour un toucher léger</translation>
    </message>
    <message>
        <source>Show me the best place</source>
        <translation>Montrer le meilleur endroit</translation>
    </message>
    <message>
        <source>How many times as stiff as its organ the lump is</source>
        <translation>Combien de fois le nodule est plus raide que son organe</translation>
    </message>
    <message>
        <source>Where the lump&apos;s stiffness comes from</source>
        <translation>D’où vient la raideur du nodule</translation>
    </message>
    <message>
        <source>As typed</source>
        <translation>Saisie</translation>
    </message>
    <message>
        <source>From the two Young&apos;s moduli</source>
        <translation>Des deux modules de Young</translation>
    </message>
    <message>
        <source>Young&apos;s modulus of the lump [kPa]</source>
        <translation>Module de Young du nodule [kPa]</translation>
    </message>
    <message>
        <source>Young&apos;s modulus of the organ [kPa]</source>
        <translation>Module de Young de l’organe [kPa]</translation>
    </message>
    <message>
        <source> kPa</source>
        <translation>&#xa0;kPa</translation>
    </message>
    <message>
        <source>by</source>
        <translation>par</translation>
    </message>
    <message>
        <source>Being computed…</source>
        <translation>Calcul en cours…</translation>
    </message>
    <message>
        <source>%1 mm</source>
        <translation>%1&#xa0;mm</translation>
    </message>
    <message>
        <source>lies open</source>
        <translation>à découvert</translation>
    </message>
    <message>
        <source>in %1</source>
        <translation>dans %1</translation>
    </message>
    <message>
        <source>between %1 and %2</source>
        <translation>entre %1 et %2</translation>
    </message>
    <message>
        <source>Times as stiff as its organ:</source>
        <translation>Combien de fois plus raide que son organe&#x202f;:</translation>
    </message>
    <message>
        <source>%1, times as stiff as %2:</source>
        <translation>%1, combien de fois plus raide que %2&#x202f;:</translation>
    </message>
    <message>
        <source>Stiffness of %1</source>
        <translation>Raideur de %1</translation>
    </message>
    <message>
        <source>No place over this lump can be judged.</source>
        <translation>Aucun endroit au-dessus de ce nodule ne peut être jugé.</translation>
    </message>
    <message>
        <source>By tissues or names</source>
        <translation>D’après tissus ou noms</translation>
    </message>
    <message>
        <source>As published: %1, %2</source>
        <translation>Publié&#x202f;: %1, %2</translation>
    </message>
    <message>
        <source>type it, or choose one that is published</source>
        <translation>saisir, ou choisir une valeur publiée</translation>
    </message>
</context>
<context>
    <name>palpate::ui::FeltWords</name>
    <message>
        <source>not by hand</source>
        <translation>pas à la main</translation>
    </message>
    <message>
        <source>by a trained hand</source>
        <translation>par une main exercée</translation>
    </message>
    <message>
        <source>plainly</source>
        <translation>nettement</translation>
    </message>
    <message>
        <source>not judged</source>
        <translation>non jugé</translation>
    </message>
    <message>
        <source>as typed</source>
        <translation>saisie</translation>
    </message>
    <message>
        <source>from the moduli</source>
        <translation>des modules</translation>
    </message>
    <message>
        <source>from the tissues&apos; stiffness</source>
        <translation>de la raideur des tissus</translation>
    </message>
    <message>
        <source>plainly felt</source>
        <translation>nettement senti</translation>
    </message>
    <message>
        <source>a trained hand tells it</source>
        <translation>une main exercée le sent</translation>
    </message>
    <message>
        <source>below what a trained hand tells</source>
        <translation>moins que ne sent une main exercée</translation>
    </message>
    <message>
        <source>the surface bends too much</source>
        <translation>la surface est trop courbée</translation>
    </message>
    <message>
        <source>the organ is too thin</source>
        <translation>l’organe est trop mince</translation>
    </message>
    <message>
        <source>lumps reach into each other</source>
        <translation>des nodules se recoupent</translation>
    </message>
    <message>
        <source>not judged here: %1</source>
        <translation>non jugé ici&#x202f;: %1</translation>
    </message>
    <message>
        <source>;
%1 when pressed %2 mm</source>
        <translation>&#x202f;;
%1 en appuyant de %2&#xa0;mm</translation>
    </message>
    <message>
        <source>no lump is felt here</source>
        <translation>aucun nodule n’est senti ici</translation>
    </message>
    <message>
        <source>%1: %2 mm below, %3 (%4 … %5 %): %6</source>
        <translation>%1&#x202f;: %2&#xa0;mm dessous, %3 (%4 … %5&#x202f;%)&#x202f;: %6</translation>
    </message>
    <message>
        <source>stiffness ratio not known</source>
        <translation>rapport de rigidité inconnu</translation>
    </message>
    <message>
        <source>published for such lumps</source>
        <translation>publié pour de telles masses</translation>
    </message>
    <message>
        <source>malignant tumour of the liver</source>
        <translation>tumeur maligne du foie</translation>
    </message>
    <message>
        <source>benign tumour of the liver</source>
        <translation>tumeur bénigne du foie</translation>
    </message>
    <message>
        <source>tumour of the liver</source>
        <translation>tumeur du foie</translation>
    </message>
    <message>
        <source>fibrotic liver</source>
        <translation>foie fibreux</translation>
    </message>
    <message>
        <source>cancer of the prostate</source>
        <translation>cancer de la prostate</translation>
    </message>
    <message>
        <source>nodule of the prostate</source>
        <translation>nodule de la prostate</translation>
    </message>
    <message>
        <source>malignant tumour of the breast</source>
        <translation>tumeur maligne du sein</translation>
    </message>
    <message>
        <source>benign tumour of the breast</source>
        <translation>tumeur bénigne du sein</translation>
    </message>
    <message>
        <source>tumour of the breast</source>
        <translation>tumeur du sein</translation>
    </message>
    <message>
        <source>malignant nodule of the thyroid</source>
        <translation>nodule malin de la thyroïde</translation>
    </message>
    <message>
        <source>benign nodule of the thyroid</source>
        <translation>nodule bénin de la thyroïde</translation>
    </message>
    <message>
        <source>nodule of the thyroid</source>
        <translation>nodule de la thyroïde</translation>
    </message>
    <message>
        <source>cancer of the pancreas</source>
        <translation>cancer du pancréas</translation>
    </message>
    <message>
        <source>benign tumour of the pancreas</source>
        <translation>tumeur bénigne du pancréas</translation>
    </message>
    <message>
        <source>tumour of the pancreas</source>
        <translation>tumeur du pancréas</translation>
    </message>
    <message>
        <source>cyst</source>
        <translation>kyste</translation>
    </message>
    <message>
        <source>vessel</source>
        <translation>vaisseau</translation>
    </message>
    <message>
        <source>%1 (at %2: %3; at %4: %5)</source>
        <translation>%1 (à %2&#x202f;: %3&#x202f;; à %4&#x202f;: %5)</translation>
    </message>
    <message>
        <source>not known</source>
        <translation>inconnu</translation>
    </message>
    <message>
        <source>%1 (at %2 times as stiff)</source>
        <translation>%1 (%2 fois plus rigide)</translation>
    </message>
</context>
<context>
    <name>palpate::ui::FindingsModel</name>
    <message>
        <source>%1: %2 N, %3 mm deep</source>
        <translation>%1&#x202f;: %2&#xa0;N, prof. %3&#xa0;mm</translation>
    </message>
    <message>
        <source>felt %1 N/mm</source>
        <translation>senti %1&#xa0;N/mm</translation>
    </message>
    <message>
        <source>Delete %1</source>
        <translation>Supprimer %1</translation>
    </message>
    <message>
        <source>Delete %1 findings</source>
        <translation>Supprimer %1 points</translation>
    </message>
    <message>
        <source>note</source>
        <translation>note</translation>
    </message>
    <message>
        <source>Number, as in the view</source>
        <translation>Numéro, comme dans la vue</translation>
    </message>
    <message>
        <source>№</source>
        <translation>N°</translation>
    </message>
    <message>
        <source>Type</source>
        <translation>Type</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Nom</translation>
    </message>
    <message>
        <source>Where</source>
        <translation>Où</translation>
    </message>
    <message>
        <source>Size across, as you judge it [mm]</source>
        <translation>Diamètre, selon votre jugement [mm]</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Taille</translation>
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
        <translation>Note</translation>
    </message>
    <message>
        <source>Type of %1</source>
        <translation>Type de %1</translation>
    </message>
    <message>
        <source>Rename %1</source>
        <translation>Renommer %1</translation>
    </message>
    <message>
        <source>Size: found “%1”, expected millimetres as %2.</source>
        <translation>Taille&#x202f;: «&#x202f;%1&#x202f;» trouvé, millimètres attendus comme %2.</translation>
    </message>
    <message>
        <source>Size of %1</source>
        <translation>Taille de %1</translation>
    </message>
    <message>
        <source>Note on %1</source>
        <translation>Note sur %1</translation>
    </message>
    <message>
        <source>%1 in %2</source>
        <translation>%1 dans %2</translation>
    </message>
    <message>
        <source>The structure that was felt, and the organ that it lies in</source>
        <translation>La structure sentie et son organe</translation>
    </message>
    <message>
        <source>Force of this structure when it was marked [N]</source>
        <translation>Force de cette structure au marquage [N]</translation>
    </message>
    <message>
        <source>Depth in this structure when it was marked [mm]</source>
        <translation>Profondeur dans cette structure au marquage [mm]</translation>
    </message>
</context>
<context>
    <name>palpate::ui::FindingsPanel</name>
    <message>
        <source>Findings and notes</source>
        <translation>Points repérés et notes</translation>
    </message>
    <message>
        <source>No finding yet. Press on a place and mark it with M; N writes a note without a place.</source>
        <translation>Aucun point repéré. Appuyer à un endroit et le marquer par M&#x202f;; N écrit une note sans endroit.</translation>
    </message>
    <message>
        <source>Write a note (N), Enter keeps it</source>
        <translation>Écrire une note (N), Entrée la garde</translation>
    </message>
    <message>
        <source>New note without a place</source>
        <translation>Nouvelle note sans endroit</translation>
    </message>
</context>
<context>
    <name>palpate::ui::ForceBar</name>
    <message>
        <source>Force in newton</source>
        <translation>Force en newtons</translation>
    </message>
    <message>
        <source>%1 N of %2 N</source>
        <translation>%1&#xa0;N sur %2&#xa0;N</translation>
    </message>
    <message>
        <source>Force of the model [N]; the bar ends at the device&apos;s limit of %1 N</source>
        <translation>Force du modèle [N]&#x202f;; la barre s’arrête à la limite de l’appareil, %1&#xa0;N</translation>
    </message>
    <message>
        <source>limit %1 N</source>
        <translation>limite %1&#xa0;N</translation>
    </message>
</context>
<context>
    <name>palpate::ui::ForceTimeline</name>
    <message>
        <source>Timeline of the recording&apos;s force</source>
        <translation>Chronologie de la force</translation>
    </message>
    <message>
        <source>Force [N] over the recording. Click or drag to go there; ← and → step 0.1 s, Home and End.</source>
        <translation>Force [N] au fil de l’enregistrement. Cliquer ou glisser pour y aller&#x202f;; ← et →&#x202f;: 0,1&#xa0;s, Début et Fin.</translation>
    </message>
    <message>
        <source>no recording</source>
        <translation>aucun enregistrement</translation>
    </message>
    <message>
        <source>%1 of %2 s</source>
        <translation>%1 sur %2&#xa0;s</translation>
    </message>
    <message>
        <source>%1, %2 N</source>
        <translation>%1, %2&#xa0;N</translation>
    </message>
    <message>
        <source>%1 s: %2</source>
        <translation>%1&#xa0;s&#x202f;: %2</translation>
    </message>
    <message>
        <source>The force of a recording appears here</source>
        <translation>La force d’un enregistrement apparaît ici</translation>
    </message>
    <message>
        <source> s</source>
        <translation>&#xa0;s</translation>
    </message>
    <message>
        <source>%1 N</source>
        <translation>%1&#xa0;N</translation>
    </message>
</context>
<context>
    <name>palpate::ui::HandControl</name>
    <message>
        <source>%1; any is used</source>
        <translation>%1&#x202f;; CPU libre</translation>
    </message>
    <message>
        <source>Touch the place, point at it or mark it as a finding (M) first.</source>
        <translation>Touchez d’abord l’endroit, pointez-le ou marquez-le comme point repéré (M).</translation>
    </message>
    <message>
        <source>Nothing is shown that the hand&apos;s space could be zoomed to.</source>
        <translation>Rien n’est affiché sur quoi zoomer l’espace de la main.</translation>
    </message>
    <message>
        <source>%1 fills the hand&apos;s space. The hand stays where it touches; Centre brings it to the middle.</source>
        <translation>L’espace de la main est rempli par&#x202f;: %1. La main reste où elle touche&#x202f;; Centrer la ramène au milieu.</translation>
    </message>
    <message>
        <source>%1 fills the hand&apos;s space.</source>
        <translation>L’espace de la main est rempli par&#x202f;: %1.</translation>
    </message>
    <message>
        <source>The whole scene</source>
        <translation>Toute la scène</translation>
    </message>
    <message>
        <source>10 mm where the hand touches</source>
        <translation>10&#xa0;mm où touche la main</translation>
    </message>
    <message>
        <source>10 mm under the pointer</source>
        <translation>10&#xa0;mm sous le pointeur</translation>
    </message>
    <message>
        <source>10 mm about finding %1</source>
        <translation>10&#xa0;mm autour du point %1</translation>
    </message>
</context>
<context>
    <name>palpate::ui::HandPanel</name>
    <message>
        <source>No motors: the force is shown, not felt, and tissue may be as stiff as you like.</source>
        <translation>Pas de moteurs&#x202f;: la force est affichée, non sentie, et le tissu peut être aussi raide que voulu.</translation>
    </message>
    <message>
        <source>This device can show tissue up to %1 N/mm.</source>
        <translation>Cet appareil peut rendre un tissu jusqu’à %1&#xa0;N/mm.</translation>
    </message>
    <message>
        <source>At the edge of the hand&apos;s space: bring the device back to its middle. The hand in the scene stays until then.</source>
        <translation>Au bord de l’espace de la main&#x202f;: ramenez l’appareil au milieu. La main dans la scène attend jusque-là.</translation>
    </message>
    <message>
        <source>Lifted: the device moves, the hand in the scene stays.</source>
        <translation>Levée&#x202f;: l’appareil bouge, la main dans la scène reste.</translation>
    </message>
    <message>
        <source>Inside %1, which is felt from outside: bring the hand out towards you first.</source>
        <translation>Dans %1, senti de l’extérieur&#x202f;: ramenez d’abord la main vers vous.</translation>
    </message>
    <message>
        <source>As it lies: the device&apos;s millimetres are the scene&apos;s.</source>
        <translation>Tel quel&#x202f;: les millimètres de l’appareil sont ceux de la scène.</translation>
    </message>
    <message>
        <source>1 mm of the device is %1 mm of the scene.</source>
        <translation>1&#xa0;mm de l’appareil vaut %1&#xa0;mm de la scène.</translation>
    </message>
    <message>
        <source>%1 fills the hand&apos;s space: 1 mm of the device is %2 mm of the scene.</source>
        <translation>L’espace de la main est rempli par&#x202f;: %1. 1&#xa0;mm de l’appareil vaut %2&#xa0;mm de la scène.</translation>
    </message>
    <message>
        <source>Nothing yet</source>
        <translation>Encore rien</translation>
    </message>
    <message>
        <source>Force on the hand</source>
        <translation>Force sur la main</translation>
    </message>
    <message>
        <source>Stiffest tissue that can be shown</source>
        <translation>Tissu le plus raide qui puisse être rendu</translation>
    </message>
    <message>
        <source>Everything</source>
        <translation>Tout</translation>
    </message>
    <message>
        <source>The device&apos;s whole way then goes through all that is shown (W)</source>
        <translation>Toute la course de l’appareil parcourt alors tout ce qui est affiché (W)</translation>
    </message>
    <message>
        <source>Organ</source>
        <translation>Organe</translation>
    </message>
    <message>
        <source>The device&apos;s whole way then goes through the organ that is touched; else the one under the pointer or selected (O)</source>
        <translation>Toute la course de l’appareil parcourt alors l’organe touché&#x202f;; sinon celui sous le pointeur ou choisi (O)</translation>
    </message>
    <message>
        <source>Lump</source>
        <translation>Nodule</translation>
    </message>
    <message>
        <source>The device&apos;s whole way is then 10 mm: where the hand touches, else under the pointer, else about the newest finding (L)</source>
        <translation>Toute la course de l’appareil vaut alors 10&#xa0;mm&#x202f;: où touche la main, sinon sous le pointeur, sinon autour du dernier point repéré (L)</translation>
    </message>
    <message>
        <source>Zoom the hand&apos;s space to</source>
        <translation>Zoomer l’espace de la main sur</translation>
    </message>
    <message>
        <source>What fills the hand&apos;s space</source>
        <translation>Ce qui remplit l’espace de la main</translation>
    </message>
    <message>
        <source> mm per mm</source>
        <translation>&#xa0;mm par mm</translation>
    </message>
    <message>
        <source>Scale</source>
        <translation>Échelle</translation>
    </message>
    <message>
        <source>Millimetres of the scene for a millimetre of the device</source>
        <translation>Millimètres de la scène pour un millimètre de l’appareil</translation>
    </message>
    <message>
        <source>The picture</source>
        <translation>L’image</translation>
    </message>
    <message>
        <source>The patient</source>
        <translation>Le patient</translation>
    </message>
    <message>
        <source>Nothing: as it lies</source>
        <translation>Rien&#x202f;: tel quel</translation>
    </message>
    <message>
        <source>What the device turns with</source>
        <translation>Avec quoi l’appareil tourne</translation>
    </message>
    <message>
        <source>The picture: right is right in the view, however it is turned.
The patient: right is to the patient&apos;s left, up is to the head.
Nothing: the device&apos;s coordinates are the scene&apos;s, without scale, and the hand cannot be lifted.</source>
        <translation>L’image&#x202f;: la droite est à droite dans la vue, quelle que soit son orientation.
Le patient&#x202f;: la droite va vers la gauche du patient, le haut vers la tête.
Rien&#x202f;: les coordonnées de l’appareil sont celles de la scène, sans échelle, et la main ne peut être levée.</translation>
    </message>
    <message>
        <source>Turns with</source>
        <translation>Tourne avec</translation>
    </message>
    <message>
        <source>Nothing</source>
        <translation>Rien</translation>
    </message>
    <message>
        <source>Lift the hand</source>
        <translation>Lever la main</translation>
    </message>
    <message>
        <source>Centre</source>
        <translation>Centrer</translation>
    </message>
    <message>
        <source>Use of button %1</source>
        <translation>Usage du bouton %1</translation>
    </message>
    <message>
        <source>Button %1</source>
        <translation>Bouton %1</translation>
    </message>
    <message>
        <source>Left hand</source>
        <translation>Main gauche</translation>
    </message>
    <message>
        <source>The first two buttons change places</source>
        <translation>Les deux premiers boutons sont échangés</translation>
    </message>
    <message>
        <source>While held the device moves and the hand in the scene stays; the key C switches it</source>
        <translation>Tant qu’il est tenu, l’appareil bouge et la main dans la scène reste&#x202f;; la touche C bascule</translation>
    </message>
    <message>
        <source>Puts the middle of the device&apos;s way in the middle of what the hand&apos;s space is zoomed to</source>
        <translation>Met le milieu de la course de l’appareil au milieu de ce sur quoi l’espace de la main est zoomé</translation>
    </message>
    <message>
        <source>Depth (wheel)</source>
        <translation>Profondeur (molette)</translation>
    </message>
    <message>
        <source>Effort (hold)</source>
        <translation>Effort (tenir)</translation>
    </message>
    <message>
        <source>What a press sets</source>
        <translation>Ce que règle un appui</translation>
    </message>
    <message>
        <source>Depth: the same depth everywhere, and a stiff place pushes back harder.
Effort: the same force everywhere, and a stiff place gives way less. The force rises by 1 N a second while the button is held; a pen gives it by its pressure. (E)</source>
        <translation>Profondeur&#x202f;: la même partout, et un endroit raide repousse plus fort.
Effort&#x202f;: la même force partout, et un endroit raide cède moins. La force croît de 1&#xa0;N par seconde tant que le bouton est tenu&#x202f;; un stylet la donne par sa pression. (E)</translation>
    </message>
    <message>
        <source>A press sets</source>
        <translation>Un appui règle</translation>
    </message>
    <message>
        <source> N</source>
        <translation>&#xa0;N</translation>
    </message>
    <message>
        <source>Greatest effort</source>
        <translation>Effort maximal</translation>
    </message>
    <message>
        <source>The press gets no harder than this, and a pen&apos;s full pressure is this; the wheel changes it by 0.5 N</source>
        <translation>L’appui ne dépasse pas cette force, que donne aussi la pleine pression d’un stylet&#x202f;; la molette la change de 0,5&#xa0;N</translation>
    </message>
    <message>
        <source>At most</source>
        <translation>Au plus</translation>
    </message>
    <message>
        <source>Force on the hand %1 N of %2 N</source>
        <translation>Force sur la main %1&#xa0;N sur %2&#xa0;N</translation>
    </message>
</context>
<context>
    <name>palpate::ui::HintLine</name>
    <message>
        <source>The newest message; F4 shows all</source>
        <translation>Le dernier message&#x202f;; F4 les affiche tous</translation>
    </message>
    <message>
        <source>%1
Press here or F4 for all messages</source>
        <translation>%1
Appuyer ici ou F4 pour tous les messages</translation>
    </message>
    <message>
        <source>No new message</source>
        <translation>Aucun nouveau message</translation>
    </message>
</context>
<context>
    <name>palpate::ui::KeysCard</name>
    <message>
        <source>All keys</source>
        <translation>Raccourcis</translation>
    </message>
    <message>
        <source>in the list: %1</source>
        <translation>dans la liste&#x202f;: %1</translation>
    </message>
</context>
<context>
    <name>palpate::ui::LawEditor</name>
    <message>
        <source>Load points…</source>
        <translation>Charger des points…</translation>
    </message>
    <message>
        <source>Linear</source>
        <translation>Linéaire</translation>
    </message>
    <message>
        <source>Stiffer with depth</source>
        <translation>Plus raide en profondeur</translation>
    </message>
    <message>
        <source>Ball on soft tissue</source>
        <translation>Boule sur tissu mou</translation>
    </message>
    <message>
        <source>Thin layer</source>
        <translation>Couche mince</translation>
    </message>
    <message>
        <source>Click</source>
        <translation>Déclic</translation>
    </message>
    <message>
        <source>Measured points</source>
        <translation>Points mesurés</translation>
    </message>
    <message>
        <source>Law</source>
        <translation>Loi</translation>
    </message>
    <message>
        <source>By what law the force rises with the depth</source>
        <translation>Selon quelle loi la force croît avec la profondeur</translation>
    </message>
    <message>
        <source>Take the points of a measured curve from a CSV file with depth_mm and force_N</source>
        <translation>Prendre les points d’une courbe mesurée dans un fichier CSV avec depth_mm et force_N</translation>
    </message>
    <message>
        <source>%1 in %2</source>
        <translation>%1 en %2</translation>
    </message>
    <message>
        <source>%1 [%2]</source>
        <translation>%1 [%2]</translation>
    </message>
    <message>
        <source>Tables (*.csv);;All files (*)</source>
        <translation>Tableaux (*.csv);;Tous les fichiers (*)</translation>
    </message>
</context>
<context>
    <name>palpate::ui::LawPlot</name>
    <message>
        <source>Force in newton by depth in millimetres</source>
        <translation>Force en newtons selon la profondeur en millimètres</translation>
    </message>
    <message>
        <source>Force [N] by depth [mm]. Drag a point; or choose one with ← → and move it with ↑ ↓</source>
        <translation>Force [N] selon la profondeur [mm]. Glisser un point&#x202f;; ou en choisir un par ← → et le déplacer par ↑ ↓</translation>
    </message>
    <message>
        <source>Force [N] by depth [mm]</source>
        <translation>Force [N] selon la profondeur [mm]</translation>
    </message>
    <message>
        <source>%1 mm deep</source>
        <translation>prof. %1&#xa0;mm</translation>
    </message>
    <message>
        <source>Force [N]</source>
        <translation>Force [N]</translation>
    </message>
    <message>
        <source>– – device %1 N/mm</source>
        <translation>– – appareil %1&#xa0;N/mm</translation>
    </message>
    <message>
        <source>now %1 mm</source>
        <translation>ici %1&#xa0;mm</translation>
    </message>
    <message>
        <source>now %1 mm, here × %2</source>
        <translation>maintenant %1&#xa0;mm, ici × %2</translation>
    </message>
</context>
<context>
    <name>palpate::ui::LiveTouch</name>
    <message>
        <source>%1 can show tissue up to %2 N/mm.</source>
        <translation>%1 peut rendre un tissu jusqu’à %2&#xa0;N/mm.</translation>
    </message>
    <message>
        <source>%1 can show tissue up to %2 N/mm here.</source>
        <translation>%1 peut rendre ici un tissu jusqu’à %2&#xa0;N/mm.</translation>
    </message>
    <message>
        <source> Its makers state no more.</source>
        <translation> Ses fabricants n’annoncent pas plus.</translation>
    </message>
    <message>
        <source> Its force comes %1 ms late: anything stiffer could make it tremble.</source>
        <translation> Sa force vient %1&#xa0;ms en retard&#x202f;: plus raide, elle pourrait trembler.</translation>
    </message>
    <message>
        <source> A millimetre of the device is %1 mm of the scene: with a smaller scale (panel Device) it can show more.</source>
        <translation> Un millimètre de l’appareil vaut %1&#xa0;mm de la scène&#x202f;: à plus petite échelle (panneau Appareil) il peut rendre plus.</translation>
    </message>
    <message>
        <source>%1 asks for %2 N/mm; %3 N/mm is felt, the most that %4 can show here%5.</source>
        <translation>%1 demande %2&#xa0;N/mm&#x202f;; on sent %3&#xa0;N/mm, le plus que %4 puisse rendre ici%5.</translation>
    </message>
    <message>
        <source> beside the layers around it</source>
        <translation> à côté des couches qui l’entourent</translation>
    </message>
</context>
<context>
    <name>palpate::ui::Looks</name>
    <message>
        <source>As the system</source>
        <translation>Comme le système</translation>
    </message>
    <message>
        <source>Light or dark, as the system is</source>
        <translation>Clair ou sombre, comme le système</translation>
    </message>
    <message>
        <source>Light</source>
        <translation>Clair</translation>
    </message>
    <message>
        <source>Dark text on light panels</source>
        <translation>Texte sombre sur panneaux clairs</translation>
    </message>
    <message>
        <source>Dark</source>
        <translation>Sombre</translation>
    </message>
    <message>
        <source>Light text on dark panels, for a dark room</source>
        <translation>Texte clair sur panneaux sombres, pour une pièce sombre</translation>
    </message>
    <message>
        <source>High contrast, on black</source>
        <translation>Contraste élevé, sur noir</translation>
    </message>
    <message>
        <source>White text on black, with edges that are seen</source>
        <translation>Texte blanc sur noir, avec des bords visibles</translation>
    </message>
    <message>
        <source>High contrast, on white</source>
        <translation>Contraste élevé, sur blanc</translation>
    </message>
    <message>
        <source>Black text on white, with edges that are seen</source>
        <translation>Texte noir sur blanc, avec des bords visibles</translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation>%1&#x202f;%</translation>
    </message>
    <message>
        <source>Texts as large as the system&apos;s</source>
        <translation>Textes aussi grands que ceux du système</translation>
    </message>
    <message>
        <source>Texts in panels and in the view</source>
        <translation>Textes dans les panneaux et dans la vue</translation>
    </message>
</context>
<context>
    <name>palpate::ui::LumpMaps</name>
    <message>
        <source>No lump lies inside an organ here: nothing to be felt through one.</source>
        <translation>Aucun nodule n’est dans un organe ici&#x202f;: rien à sentir à travers un organe.</translation>
    </message>
    <message>
        <source>Making what is felt through %1; until then a lump in it is felt as a layer</source>
        <translation>Calcul de ce qui se sent à travers %1&#x202f;; d’ici là un nodule y est une couche</translation>
    </message>
    <message>
        <source>What can be felt of %1</source>
        <translation>Ce qui se sent de %1</translation>
    </message>
    <message>
        <source>What is felt through an organ was cancelled: lumps are felt as layers until the scene changes.</source>
        <translation>Le calcul de ce qui se sent à travers un organe a été annulé&#x202f;: les nodules sont des couches jusqu’au prochain changement de la scène.</translation>
    </message>
    <message>
        <source>What can be felt here was cancelled.</source>
        <translation>Le calcul de ce qui se sent ici a été annulé.</translation>
    </message>
    <message>
        <source>How many times as stiff as %1 is %2? It is not known, so no verdict is given: type it in What can be felt (B), or choose one that is published.</source>
        <translation>Combien de fois %2 est-il plus rigide que %1&#x202f;? Inconnu, donc aucun verdict&#x202f;: à saisir dans «&#x202f;Ce qui se sent&#x202f;» (B), ou choisir une valeur publiée.</translation>
    </message>
</context>
<context>
    <name>palpate::ui::MapDisplay</name>
    <message>
        <source>Young&apos;s modulus, kPa</source>
        <translation>module d’Young, kPa</translation>
    </message>
    <message>
        <source>shear modulus, kPa</source>
        <translation>module de cisaillement, kPa</translation>
    </message>
    <message>
        <source>resists fast movement, N·s/mm</source>
        <translation>freine les gestes vifs, N·s/mm</translation>
    </message>
    <message>
        <source>friction, times the tissue&apos;s own</source>
        <translation>frottement, multiple de celui du tissu</translation>
    </message>
    <message>
        <source>stiffness felt, N/mm</source>
        <translation>raideur sentie, N/mm</translation>
    </message>
    <message>
        <source>stiffness felt, times the law</source>
        <translation>raideur sentie, multiple de la loi</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1&#x202f;: %2</translation>
    </message>
    <message>
        <source>%1: nothing said</source>
        <translation>%1&#x202f;: rien d’indiqué</translation>
    </message>
    <message>
        <source>nothing said</source>
        <translation>rien d’indiqué</translation>
    </message>
</context>
<context>
    <name>palpate::ui::MapEditor</name>
    <message>
        <source>Map</source>
        <translation>Carte</translation>
    </message>
    <message>
        <source>How the tissue varies over the surface</source>
        <translation>Comment le tissu varie sur la surface</translation>
    </message>
    <message>
        <source>By name</source>
        <translation>Par nom</translation>
    </message>
    <message>
        <source>None</source>
        <translation>Aucune</translation>
    </message>
    <message>
        <source>By hand</source>
        <translation>À la main</translation>
    </message>
    <message>
        <source>The arrays of the mesh whose names say what they are, such as StiffnessScale</source>
        <translation>Les tableaux du maillage dont le nom dit ce qu’ils sont, comme StiffnessScale</translation>
    </message>
    <message>
        <source>Varies</source>
        <translation>Varie</translation>
    </message>
    <message>
        <source>What of the tissue varies</source>
        <translation>Ce qui varie dans le tissu</translation>
    </message>
    <message>
        <source>Stiffness</source>
        <translation>Raideur</translation>
    </message>
    <message>
        <source>Resists fast movement</source>
        <translation>Freine les gestes vifs</translation>
    </message>
    <message>
        <source>Friction</source>
        <translation>Frottement</translation>
    </message>
    <message>
        <source>By</source>
        <translation>Selon</translation>
    </message>
    <message>
        <source>Which array of the mesh, or which volume, says it</source>
        <translation>Quel tableau du maillage, ou quel volume, le dit</translation>
    </message>
    <message>
        <source>In</source>
        <translation>En</translation>
    </message>
    <message>
        <source>What the numbers are. Shear and Young&apos;s modulus differ by a factor of three: see what the scanner&apos;s manual says</source>
        <translation>Ce que sont les nombres. Module de cisaillement et module d’Young diffèrent d’un facteur trois&#x202f;: voir le manuel de l’imageur</translation>
    </message>
    <message>
        <source>say which…</source>
        <translation>à préciser…</translation>
    </message>
    <message>
        <source>Times the tissue&apos;s own</source>
        <translation>Multiple de la valeur du tissu</translation>
    </message>
    <message>
        <source>N/mm, as felt</source>
        <translation>N/mm, tels que sentis</translation>
    </message>
    <message>
        <source>Shear modulus, kPa</source>
        <translation>Module de cisaillement, kPa</translation>
    </message>
    <message>
        <source>Young&apos;s modulus, kPa</source>
        <translation>Module d’Young, kPa</translation>
    </message>
    <message>
        <source>Contact radius in mm</source>
        <translation>Rayon de contact en mm</translation>
    </message>
    <message>
        <source> mm</source>
        <translation>&#xa0;mm</translation>
    </message>
    <message>
        <source>Of the finger that feels a modulus: the stiffness is 8 times radius times shear modulus</source>
        <translation>Du doigt qui sent un module&#x202f;: la raideur vaut 8 fois le rayon fois le module de cisaillement</translation>
    </message>
    <message>
        <source>Contact radius</source>
        <translation>Rayon de contact</translation>
    </message>
    <message>
        <source>Keep numbers within</source>
        <translation>Borner les nombres</translation>
    </message>
    <message>
        <source>Numbers beyond are taken as the nearest one within</source>
        <translation>Les nombres hors bornes sont ramenés à la borne la plus proche</translation>
    </message>
    <message>
        <source>At least</source>
        <translation>Au moins</translation>
    </message>
    <message>
        <source>At most</source>
        <translation>Au plus</translation>
    </message>
    <message>
        <source>to</source>
        <translation>à</translation>
    </message>
    <message>
        <source>What the map says</source>
        <translation>Ce que dit la carte</translation>
    </message>
    <message>
        <source>Show</source>
        <translation>Afficher</translation>
    </message>
    <message>
        <source>Colours the structure by numbers, with a legend</source>
        <translation>Colore la structure selon les nombres, avec une légende</translation>
    </message>
    <message>
        <source>Volume</source>
        <translation>Volume</translation>
    </message>
    <message>
        <source>Volumes (*.vti *.mha *.mhd *.nrrd *.nhdr *.nii *.nii.gz);;All files (*)</source>
        <translation>Volumes (*.vti *.mha *.mhd *.nrrd *.nhdr *.nii *.nii.gz);;Tous les fichiers (*)</translation>
    </message>
    <message>
        <source>Nothing</source>
        <translation>Rien</translation>
    </message>
    <message>
        <source>Volume…</source>
        <translation>Volume…</translation>
    </message>
    <message>
        <source>Own colour</source>
        <translation>Couleur propre</translation>
    </message>
    <message>
        <source>Say what the numbers of %1 are: shear and Young&apos;s modulus differ by a factor of three.</source>
        <translation>Précisez ce que sont les nombres de %1&#x202f;: module de cisaillement et module d’Young diffèrent d’un facteur trois.</translation>
    </message>
    <message>
        <source>%1 varies by %2.</source>
        <translation>%1 varie selon %2.</translation>
    </message>
    <message>
        <source>%1: %2 of %3 places say nothing. The tissue&apos;s own is felt there.</source>
        <translation>%1&#x202f;: %2 endroits sur %3 n’indiquent rien. La valeur du tissu y est sentie.</translation>
    </message>
</context>
<context>
    <name>palpate::ui::MapWarnings</name>
    <message>
        <source>(%1; %2; %3) mm</source>
        <translation>(%1&#x202f;; %2&#x202f;; %3) mm</translation>
    </message>
    <message>
        <source>%1: what the lumps below make of it changes too sharply for the %2 at %3.</source>
        <translation>%1&#x202f;: ce que les nodules dessous en font change trop brusquement pour «&#x202f;%2&#x202f;» en %3.</translation>
    </message>
    <message>
        <source>%1: its map of stiffness bends too sharply for the %2 at %3.</source>
        <translation>%1&#x202f;: sa carte de rigidité se plie trop brusquement pour «&#x202f;%2&#x202f;» en %3.</translation>
    </message>
    <message>
        <source>The push aside jumps by %1 N there and can keep the hand swinging by %2 mm.</source>
        <translation>La force latérale y saute de %1 N et peut faire osciller la main de %2 mm.</translation>
    </message>
    <message>
        <source>Give the tissue friction, or open a mesh with shorter edges there.</source>
        <translation>Donner du frottement au tissu, ou ouvrir un maillage aux arêtes plus courtes à cet endroit.</translation>
    </message>
    <message>
        <source>Spread the step over more millimetres, round its ends, or give the tissue friction.</source>
        <translation>Étaler la marche sur plus de millimètres, arrondir ses bouts, ou donner du frottement au tissu.</translation>
    </message>
</context>
<context>
    <name>palpate::ui::MessageBar</name>
    <message>
        <source> … and %1 more lines (F4)</source>
        <translation> … et %1 lignes de plus (F4)</translation>
    </message>
    <message>
        <source>Show the list of messages (F4)</source>
        <translation>Afficher la liste des messages (F4)</translation>
    </message>
    <message>
        <source>1 older message waits (F4 shows all)</source>
        <translation>1 message antérieur attend (F4 affiche tout)</translation>
    </message>
    <message>
        <source>%1 older messages wait (F4 shows all)</source>
        <translation>%1 messages antérieurs attendent (F4 affiche tout)</translation>
    </message>
</context>
<context>
    <name>palpate::ui::MessageList</name>
    <message>
        <source>Messages</source>
        <translation>Messages</translation>
    </message>
    <message>
        <source>Copy (Ctrl+C)</source>
        <translation>Copier (Ctrl+C)</translation>
    </message>
</context>
<context>
    <name>palpate::ui::MessageRow</name>
    <message>
        <source>Close this message; the list of messages keeps it (F4)</source>
        <translation>Fermer ce message&#x202f;; la liste des messages le garde (F4)</translation>
    </message>
    <message>
        <source>Close this message</source>
        <translation>Fermer ce message</translation>
    </message>
</context>
<context>
    <name>palpate::ui::Messages</name>
    <message>
        <source>%1: %2</source>
        <translation>%1&#x202f;: %2</translation>
    </message>
    <message>
        <source>Told</source>
        <translation>Info</translation>
    </message>
    <message>
        <source>Warning</source>
        <translation>Alerte</translation>
    </message>
    <message>
        <source>Error</source>
        <translation>Erreur</translation>
    </message>
    <message>
        <source>Offer</source>
        <translation>Proposition</translation>
    </message>
</context>
<context>
    <name>palpate::ui::PalpationController</name>
    <message>
        <source>%1 mm is the deepest press: the scene is no larger.</source>
        <translation>%1&#xa0;mm est l’appui le plus profond&#x202f;: la scène n’est pas plus grande.</translation>
    </message>
    <message>
        <source>%1 N is the hardest press.</source>
        <translation>%1&#xa0;N est l’appui le plus fort.</translation>
    </message>
    <message>
        <source>Nothing that can be felt is in view.</source>
        <translation>Rien de palpable n’est dans la vue.</translation>
    </message>
    <message>
        <source>camera</source>
        <translation>caméra</translation>
    </message>
    <message>
        <source>presses up to %1 N</source>
        <translation>appuie jusqu’à %1&#xa0;N</translation>
    </message>
    <message>
        <source>pressing %1 mm, slid off the edge</source>
        <translation>appui %1&#xa0;mm, glissé hors du bord</translation>
    </message>
    <message>
        <source>presses %1 mm</source>
        <translation>appuie de %1&#xa0;mm</translation>
    </message>
    <message>
        <source>pressing %1 mm</source>
        <translation>appui %1&#xa0;mm</translation>
    </message>
    <message>
        <source>pressing %1 of %2 mm</source>
        <translation>appui %1 sur %2&#xa0;mm</translation>
    </message>
    <message>
        <source>aims at %1 of %2 N, reaches %3 N, %4 mm</source>
        <translation>vise %1 sur %2 N, atteint %3 N, %4 mm</translation>
    </message>
</context>
<context>
    <name>palpate::ui::Playback</name>
    <message>
        <source>structure %1</source>
        <translation>structure %1</translation>
    </message>
</context>
<context>
    <name>palpate::ui::RecordedTouch</name>
    <message>
        <source>%1 ended at %2 s because the disk was full; what was felt after is not in it.</source>
        <translation>%1 s’est arrêté à %2&#xa0;s car le disque était plein&#x202f;; ce qui a été senti ensuite n’y figure pas.</translation>
    </message>
    <message>
        <source>%1 ended at %2 s because the disk could not be written; what was felt after is not in it.</source>
        <translation>%1 s’est arrêté à %2&#xa0;s car l’écriture sur le disque a échoué&#x202f;; ce qui a été senti ensuite n’y figure pas.</translation>
    </message>
    <message>
        <source>%1 was not closed (a crash, or a full disk): it ends at %2 s, and what was felt after is not in it.</source>
        <translation>%1 n’a pas été fermé (plantage ou disque plein)&#x202f;: il s’arrête à %2&#xa0;s, et ce qui a été senti ensuite n’y figure pas.</translation>
    </message>
    <message>
        <source>%1: %2 moments were lost while it was recorded, because the disk was too slow.</source>
        <translation>%1&#x202f;: %2 instants ont été perdus à l’enregistrement, le disque étant trop lent.</translation>
    </message>
    <message numerus="yes">
        <source>%1 is damaged, or was changed after it was recorded: %n place(s) do not match their checksums. What was felt there is left out; &quot;palpate session verify&quot; names the first place.</source>
        <translation>
            <numerusform>%1 est endommagé, ou a été modifié après l’enregistrement&#x202f;: %n endroit ne correspond pas à sa somme de contrôle. Ce qui y fut senti est omis&#x202f;; «&#x202f;palpate session verify&#x202f;» nomme le premier endroit.</numerusform>
            <numerusform>%1 est endommagé, ou a été modifié après l’enregistrement&#x202f;: %n endroits ne correspondent pas à leurs sommes de contrôle. Ce qui y fut senti est omis&#x202f;; «&#x202f;palpate session verify&#x202f;» nomme le premier endroit.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>palpate::ui::SceneLoader</name>
    <message>
        <source>Nothing to open.</source>
        <translation>Rien à ouvrir.</translation>
    </message>
    <message>
        <source>Reading %1</source>
        <translation>Lecture de %1</translation>
    </message>
    <message>
        <source>its view</source>
        <translation>sa vue</translation>
    </message>
    <message>
        <source>the fields of it that this version does not know</source>
        <translation>ses champs que cette version ne connaît pas</translation>
    </message>
    <message>
        <source>%1: opened together with another scene; not taken: %2</source>
        <translation>%1&#x202f;: ouvert avec une autre scène&#x202f;; non repris&#x202f;: %2</translation>
    </message>
    <message>
        <source>, </source>
        <translation>, </translation>
    </message>
    <message>
        <source>Preparing for touch</source>
        <translation>Préparation du toucher</translation>
    </message>
</context>
<context>
    <name>palpate::ui::SessionPanel</name>
    <message>
        <source>Position and length</source>
        <translation>Position et durée</translation>
    </message>
    <message>
        <source>Position / length [min:s]</source>
        <translation>Position / durée [min:s]</translation>
    </message>
    <message>
        <source>%1 ×</source>
        <translation>%1&#xa0;×</translation>
    </message>
    <message>
        <source>Speed of playing; 1 × is as it was recorded</source>
        <translation>Vitesse de lecture&#x202f;; 1&#xa0;× est celle de l’enregistrement</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>Vitesse</translation>
    </message>
    <message>
        <source>No recording yet. Record one with R, or open a .palpate file.</source>
        <translation>Aucun enregistrement. En faire un avec R, ou ouvrir un fichier .palpate.</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <translation>%1, %2</translation>
    </message>
    <message>
        <source>%1 late, %2 lost</source>
        <translation>%1 en retard, %2 perdus</translation>
    </message>
</context>
<context>
    <name>palpate::ui::StructureList</name>
    <message>
        <source>Structures</source>
        <translation>Structures</translation>
    </message>
    <message>
        <source>Filter by name</source>
        <translation>Filtrer par nom</translation>
    </message>
    <message>
        <source>Filter the structures by name</source>
        <translation>Filtrer les structures par nom</translation>
    </message>
    <message>
        <source>List only what has these words in its name (Ctrl+F); Esc lists all</source>
        <translation>Ne lister que ce dont le nom contient ces mots (Ctrl+F)&#x202f;; Échap liste tout</translation>
    </message>
    <message>
        <source>Order and groups of the list</source>
        <translation>Ordre et groupes de la liste</translation>
    </message>
    <message>
        <source>Order</source>
        <translation>Ordre</translation>
    </message>
    <message>
        <source>As opened</source>
        <translation>Comme ouvert</translation>
    </message>
    <message>
        <source>By name</source>
        <translation>Par nom</translation>
    </message>
    <message>
        <source>By tissue, softest first</source>
        <translation>Par tissu, le plus mou d’abord</translation>
    </message>
    <message>
        <source>By layer, outermost first</source>
        <translation>Par couche, de dehors en dedans</translation>
    </message>
    <message>
        <source>Groups</source>
        <translation>Groupes</translation>
    </message>
    <message>
        <source>None</source>
        <translation>Aucun</translation>
    </message>
    <message>
        <source>By file or folder</source>
        <translation>Par fichier ou dossier</translation>
    </message>
    <message>
        <source>By layer, as felt</source>
        <translation>Par couche sentie</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1 sur %2</translation>
    </message>
</context>
<context>
    <name>palpate::ui::StructureModel</name>
    <message>
        <source>Change %1</source>
        <translation>Modifier %1</translation>
    </message>
    <message>
        <source>Remove %1</source>
        <translation>Retirer %1</translation>
    </message>
    <message>
        <source>Remove %1 structures</source>
        <translation>Retirer %1 structures</translation>
    </message>
    <message>
        <source>outermost</source>
        <translation>en premier</translation>
    </message>
    <message>
        <source>below %1</source>
        <translation>sous %1</translation>
    </message>
    <message>
        <source>%1 below</source>
        <translation>%1 en dessous</translation>
    </message>
    <message>
        <source>The mesh is open: feels like a sheet</source>
        <translation>Le maillage est ouvert&#x202f;: senti comme une feuille</translation>
    </message>
    <message>
        <source>Part of the mesh is open: feels like a sheet there</source>
        <translation>Une partie du maillage est ouverte&#x202f;: sentie là comme une feuille</translation>
    </message>
    <message>
        <source>The mesh is inside out: felt from within only</source>
        <translation>Le maillage est retourné&#x202f;: senti seulement de l’intérieur</translation>
    </message>
    <message>
        <source>The mesh had faults, which were mended</source>
        <translation>Le maillage avait des défauts, qui ont été corrigés</translation>
    </message>
    <message>
        <source>The mesh branches along some edges</source>
        <translation>Le maillage se ramifie le long de certaines arêtes</translation>
    </message>
    <message>
        <source>%1 is shown. Click to hide it; what is hidden is not felt.</source>
        <translation>%1 est visible. Cliquer pour masquer&#x202f;; ce qui est masqué n’est pas senti.</translation>
    </message>
    <message>
        <source>%1 is hidden. Click to show it.</source>
        <translation>%1 est invisible. Cliquer pour afficher.</translation>
    </message>
    <message>
        <source>%1, felt %2</source>
        <translation>%1, se sent %2</translation>
    </message>
    <message>
        <source>%1
%2 triangles
Felt: %3</source>
        <translation>%1
%2 triangles
Senti&#x202f;: %3</translation>
    </message>
    <message>
        <source>About the mesh of %1:
• %2
The list of messages (F4) has the details.</source>
        <translation>Sur le maillage de %1&#x202f;:
• %2
La liste des messages (F4) donne les détails.</translation>
    </message>
    <message>
        <source>%1 can be felt. Click to let the hand pass through it.</source>
        <translation>%1 est palpable. Cliquer pour que la main passe à travers.</translation>
    </message>
    <message>
        <source>The hand passes through %1. Click to feel it.</source>
        <translation>La main passe à travers %1. Cliquer pour rendre palpable.</translation>
    </message>
    <message>
        <source>Structure</source>
        <translation>Structure</translation>
    </message>
    <message>
        <source>Shown</source>
        <translation>Visible</translation>
    </message>
    <message>
        <source>Name and colour</source>
        <translation>Nom et couleur</translation>
    </message>
    <message>
        <source>What was found in the mesh</source>
        <translation>Remarques sur le maillage</translation>
    </message>
    <message>
        <source>Can be felt</source>
        <translation>Palpable</translation>
    </message>
    <message>
        <source>Rename %1</source>
        <translation>Renommer %1</translation>
    </message>
    <message>
        <source>through %1</source>
        <translation>à travers %1</translation>
    </message>
    <message>
        <source>Turn %1 around</source>
        <translation>Retourner %1</translation>
    </message>
    <message>
        <source>Turn %1 surfaces around</source>
        <translation>Retourner %1 surfaces</translation>
    </message>
    <message>
        <source>Smooth %1</source>
        <translation>Lisser %1</translation>
    </message>
    <message>
        <source>Smooth %1 surfaces</source>
        <translation>Lisser %1 surfaces</translation>
    </message>
    <message>
        <source>The surface is smoothed: moved by at most %1 mm</source>
        <translation>La surface est lissée&#x202f;: déplacée de %1 mm au plus</translation>
    </message>
    <message>
        <source>The surface is smoothed: moved by at most %1 mm, volume %2 %</source>
        <translation>La surface est lissée&#x202f;: déplacée de %1 mm au plus, volume %2 %</translation>
    </message>
    <message>
        <source>The surface is a staircase of %1 × %2 × %3 mm voxels: the hand feels its steps</source>
        <translation>La surface est un escalier de voxels de %1 × %2 × %3 mm&#x202f;: la main sent ses marches</translation>
    </message>
</context>
<context>
    <name>palpate::ui::StructurePanel</name>
    <message>
        <source>Colour of the structure</source>
        <translation>Couleur de la structure</translation>
    </message>
    <message>
        <source>Colour</source>
        <translation>Couleur</translation>
    </message>
    <message>
        <source>Opacity in per cent</source>
        <translation>Opacité en pour cent</translation>
    </message>
    <message>
        <source>Opacity [%]: what lies behind shows through</source>
        <translation>Opacité [%]&#x202f;: ce qui est derrière transparaît</translation>
    </message>
    <message>
        <source>Opacity</source>
        <translation>Opacité</translation>
    </message>
    <message>
        <source>%1 as felt [%2]: %3</source>
        <translation>%1, comme senti [%2]&#x202f;: %3</translation>
    </message>
    <message>
        <source>%1 in %2</source>
        <translation>%1 en %2</translation>
    </message>
    <message>
        <source>Custom</source>
        <translation>Personnalisé</translation>
    </message>
    <message>
        <source>Tissue</source>
        <translation>Tissu</translation>
    </message>
    <message>
        <source>How the structure feels, by name</source>
        <translation>Comment la structure se sent, par nom</translation>
    </message>
    <message>
        <source>Friction</source>
        <translation>Frottement</translation>
    </message>
    <message>
        <source>How much the surface holds the fingertip, by name</source>
        <translation>Combien la surface retient le bout du doigt, par nom</translation>
    </message>
    <message>
        <source>What is felt of it</source>
        <translation>Ce qui en est senti</translation>
    </message>
    <message>
        <source>Why the value was refused</source>
        <translation>Pourquoi la valeur a été refusée</translation>
    </message>
    <message>
        <source>Felt, in order from outside</source>
        <translation>Senti, de dehors en dedans</translation>
    </message>
    <message>
        <source>What a hand meets first as it presses in, and what it meets through that (Ctrl+Down, Ctrl+Up in the list)</source>
        <translation>Ce que la main rencontre d’abord en appuyant, et ce qu’elle rencontre à travers (Ctrl+Bas, Ctrl+Haut dans la liste)</translation>
    </message>
    <message>
        <source>Felt</source>
        <translation>Senti</translation>
    </message>
    <message>
        <source>Change %1 structures</source>
        <translation>Modifier %1 structures</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1&#x202f;: %2</translation>
    </message>
    <message>
        <source>%1 structures</source>
        <translation>%1 structures</translation>
    </message>
    <message>
        <source>The list of messages (F4) has the details</source>
        <translation>La liste des messages (F4) donne les détails</translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation>%1&#x202f;%</translation>
    </message>
    <message>
        <source>No structure selected</source>
        <translation>Aucune structure choisie</translation>
    </message>
    <message>
        <source>Source: %1</source>
        <translation>Source&#x202f;: %1</translation>
    </message>
    <message>
        <source>%1 takes %2</source>
        <translation>%1 prend %2</translation>
    </message>
    <message>
        <source>felt as at most %1 N/mm: the device can show %2 N/mm in all%3</source>
        <translation>senti comme %1&#xa0;N/mm au plus&#x202f;: l’appareil peut rendre %2&#xa0;N/mm en tout%3</translation>
    </message>
    <message>
        <source>felt as %1 N/mm: the device can show %2 N/mm in all%3</source>
        <translation>senti comme %1&#xa0;N/mm&#x202f;: l’appareil peut rendre %2&#xa0;N/mm en tout%3</translation>
    </message>
    <message>
        <source>This law is refused: %1.</source>
        <translation>Cette loi est refusée&#x202f;: %1.</translation>
    </message>
    <message>
        <source>%1 N·s/mm is refused: the device can resist movement with %2 N·s/mm at most. Enter that or less.</source>
        <translation>%1&#xa0;N·s/mm est refusé&#x202f;: l’appareil peut freiner le mouvement de %2&#xa0;N·s/mm au plus. Saisissez cela ou moins.</translation>
    </message>
    <message>
        <source>%1 Of that %2.</source>
        <translation>%1 De cela, %2.</translation>
    </message>
    <message>
        <source>%1 N/mm is refused. %2 Enter %3 N/mm or less.</source>
        <translation>%1&#xa0;N/mm&#x202f;: refusé. %2 Entrez %3&#xa0;N/mm ou moins.</translation>
    </message>
    <message>
        <source>A law that rises by %1 N/mm where it is steepest is refused. %2 Enter numbers by which it rises by %3 N/mm or less.</source>
        <translation>Une loi qui croît de %1&#xa0;N/mm au plus raide est refusée. %2 Entrez des nombres avec lesquels elle croît de %3&#xa0;N/mm ou moins.</translation>
    </message>
    <message>
        <source>Colour of %1</source>
        <translation>Couleur de %1</translation>
    </message>
    <message>
        <source>Show only what is selected</source>
        <translation>N’afficher que la sélection</translation>
    </message>
    <message>
        <source>Feel only what is selected</source>
        <translation>Ne sentir que la sélection</translation>
    </message>
    <message>
        <source>Show all</source>
        <translation>Tout afficher</translation>
    </message>
    <message>
        <source>Feel all</source>
        <translation>Tout sentir</translation>
    </message>
    <message>
        <source>Rename…</source>
        <translation>Renommer…</translation>
    </message>
    <message>
        <source>Remove from the scene</source>
        <translation>Retirer de la scène</translation>
    </message>
    <message>
        <source>numbers chosen</source>
        <translation>nombres choisis</translation>
    </message>
    <message>
        <source>shear modulus by MR elastography (PMC2894569), as a fingertip of 5 mm radius feels it</source>
        <translation>module de cisaillement par élastographie IRM (PMC2894569), senti par un bout de doigt de 5&#xa0;mm de rayon</translation>
    </message>
    <message>
        <source>Very soft organ</source>
        <translation>Organe très mou</translation>
    </message>
    <message>
        <source>Soft organ</source>
        <translation>Organe mou</translation>
    </message>
    <message>
        <source>Firm organ</source>
        <translation>Organe ferme</translation>
    </message>
    <message>
        <source>Firm lump</source>
        <translation>Nodule ferme</translation>
    </message>
    <message>
        <source>Hard lump</source>
        <translation>Nodule dur</translation>
    </message>
    <message>
        <source>Bone</source>
        <translation>Os</translation>
    </message>
    <message>
        <source>Liver, healthy (2.3 kPa)</source>
        <translation>Foie, sain (2,3&#xa0;kPa)</translation>
    </message>
    <message>
        <source>Liver, fibrotic (5.9 kPa)</source>
        <translation>Foie, fibreux (5,9&#xa0;kPa)</translation>
    </message>
    <message>
        <source>Liver, malignant (10.1 kPa)</source>
        <translation>Foie, malin (10,1&#xa0;kPa)</translation>
    </message>
    <message>
        <source>Liver, stiffer with depth</source>
        <translation>Foie, plus raide en profondeur</translation>
    </message>
    <message>
        <source>shape after Carter et al. 2001 (exponential), numbers chosen</source>
        <translation>forme d’après Carter et al. 2001 (exponentielle), nombres choisis</translation>
    </message>
    <message>
        <source>Soft ground under a ball</source>
        <translation>Fond mou sous une boule</translation>
    </message>
    <message>
        <source>shape after Hertz 1882, numbers chosen</source>
        <translation>forme d’après Hertz 1882, nombres choisis</translation>
    </message>
    <message>
        <source>Button that clicks</source>
        <translation>Bouton à déclic</translation>
    </message>
    <message>
        <source>None</source>
        <translation>Aucun</translation>
    </message>
    <message>
        <source>Wet (0.05, chosen)</source>
        <translation>Mouillé (0,05, choisi)</translation>
    </message>
    <message>
        <source>Moist (0.15, chosen)</source>
        <translation>Humide (0,15, choisi)</translation>
    </message>
    <message>
        <source>Dry (0.40, chosen)</source>
        <translation>Sec (0,40, choisi)</translation>
    </message>
    <message>
        <source>Change %1</source>
        <translation>Modifier %1</translation>
    </message>
    <message>
        <source>on its own surface, outermost</source>
        <translation>sur sa propre surface, en premier</translation>
    </message>
    <message>
        <source>as a layer, %1</source>
        <translation>comme couche, %1</translation>
    </message>
    <message>
        <source>%1 (felt from above)</source>
        <translation>%1 (senti d’en haut)</translation>
    </message>
    <message>
        <source>through %1 (felt from above)</source>
        <translation>à travers %1 (senti d’en haut)</translation>
    </message>
    <message>
        <source>What its map can do to the device</source>
        <translation>Ce que sa carte peut faire à l’appareil</translation>
    </message>
    <message>
        <source>As in the file</source>
        <translation>Comme dans le fichier</translation>
    </message>
    <message>
        <source>Smoothed</source>
        <translation>Lissée</translation>
    </message>
    <message>
        <source>Surface</source>
        <translation>Surface</translation>
    </message>
    <message>
        <source>Smoothing takes away the steps of voxels, by at most half a voxel, for the eye and for the hand. The file is not changed.</source>
        <translation>Le lissage enlève les marches des voxels, d’un demi-voxel au plus, pour l’œil et la main. Le fichier n’est pas modifié.</translation>
    </message>
    <message>
        <source>Turn around</source>
        <translation>Retourner</translation>
    </message>
    <message>
        <source>Young&apos;s modulus by shear-wave ultrasound (Arda et al. 2011, AJR 197:532), as a fingertip of 5 mm radius feels it</source>
        <translation>Module de Young par ultrasons à ondes de cisaillement (Arda et al. 2011, AJR 197:532), tel qu’un bout de doigt de 5 mm de rayon le sent</translation>
    </message>
    <message>
        <source>Kidney (5.0 kPa)</source>
        <translation>Rein (5,0 kPa)</translation>
    </message>
    <message>
        <source>Spleen (2.9 kPa)</source>
        <translation>Rate (2,9 kPa)</translation>
    </message>
    <message>
        <source>Pancreas (4.8 kPa)</source>
        <translation>Pancréas (4,8 kPa)</translation>
    </message>
    <message>
        <source>Thyroid (11.0 kPa)</source>
        <translation>Thyroïde (11,0 kPa)</translation>
    </message>
    <message>
        <source>Salivary gland (10.9 kPa)</source>
        <translation>Glande salivaire (10,9 kPa)</translation>
    </message>
    <message>
        <source>Muscle at rest (11.1 kPa)</source>
        <translation>Muscle au repos (11,1 kPa)</translation>
    </message>
    <message>
        <source>Tendon (51.5 kPa)</source>
        <translation>Tendon (51,5 kPa)</translation>
    </message>
    <message>
        <source>Prostate (17.0 kPa)</source>
        <translation>Prostate (17,0 kPa)</translation>
    </message>
    <message>
        <source>Young&apos;s modulus by indentation (Urology 2010), as a fingertip of 5 mm radius feels it</source>
        <translation>Module de Young par indentation (Urology 2010), tel qu’un bout de doigt de 5 mm de rayon le sent</translation>
    </message>
    <message>
        <source>Breast (3.2 kPa)</source>
        <translation>Sein (3,2 kPa)</translation>
    </message>
    <message>
        <source>Young&apos;s modulus by indentation (Teixeira et al. 2023), as a fingertip of 5 mm radius feels it</source>
        <translation>Module de Young par indentation (Teixeira et al. 2023), tel qu’un bout de doigt de 5 mm de rayon le sent</translation>
    </message>
    <message>
        <source>Lymph node</source>
        <translation>Ganglion</translation>
    </message>
    <message>
        <source>number chosen below 22 kPa, above which lymph nodes count as malignant (2.71 m/s by shear-wave ultrasound)</source>
        <translation>valeur choisie sous 22 kPa, seuil de malignité des ganglions (2,71 m/s par ultrasons à ondes de cisaillement)</translation>
    </message>
</context>
<context>
    <name>palpate::ui::StructureTree</name>
    <message>
        <source>Felt outermost</source>
        <translation>Senti en premier</translation>
    </message>
    <message>
        <source>Felt %1 below</source>
        <translation>Senti %1 en dessous</translation>
    </message>
    <message>
        <source>Other</source>
        <translation>Autre</translation>
    </message>
    <message>
        <source>%1 (%2)</source>
        <translation>%1 (%2)</translation>
    </message>
    <message>
        <source>Hide all of %1</source>
        <translation>Tout masquer&#x202f;: %1</translation>
    </message>
    <message>
        <source>Show all of %1</source>
        <translation>Tout afficher&#x202f;: %1</translation>
    </message>
    <message>
        <source>Let the hand pass through all of %1</source>
        <translation>Laisser passer la main à travers tout&#x202f;: %1</translation>
    </message>
    <message>
        <source>Feel all of %1</source>
        <translation>Tout sentir&#x202f;: %1</translation>
    </message>
</context>
<context>
    <name>palpate::ui::Terms</name>
    <message>
        <source>Stiffness</source>
        <translation>Raideur</translation>
    </message>
    <message>
        <source>force for each mm pressed in</source>
        <translation>force par mm enfoncé</translation>
    </message>
    <message>
        <source>newton per millimetre</source>
        <translation>newtons par millimètre</translation>
    </message>
    <message>
        <source>Resists fast movement</source>
        <translation>Freine les gestes vifs</translation>
    </message>
    <message>
        <source>force against each mm/s of movement</source>
        <translation>force contre chaque mm/s de mouvement</translation>
    </message>
    <message>
        <source>newton seconds per millimetre</source>
        <translation>newtons-secondes par millimètre</translation>
    </message>
    <message>
        <source>Friction at rest</source>
        <translation>Frottement au repos</translation>
    </message>
    <message>
        <source>share of the normal force that holds</source>
        <translation>part de la force normale qui retient</translation>
    </message>
    <message>
        <source>Friction sliding</source>
        <translation>Frottement glissant</translation>
    </message>
    <message>
        <source>share of the normal force that drags while it slides</source>
        <translation>part de la force normale qui freine le glissement</translation>
    </message>
    <message>
        <source>Drag</source>
        <translation>Freinage</translation>
    </message>
    <message>
        <source>force against each mm/s of sliding</source>
        <translation>force contre chaque mm/s de glissement</translation>
    </message>
    <message>
        <source>Stiffness at first touch</source>
        <translation>Raideur au premier contact</translation>
    </message>
    <message>
        <source>Growth with depth</source>
        <translation>Hausse en profondeur</translation>
    </message>
    <message>
        <source>Greatest stiffness</source>
        <translation>Raideur maximale</translation>
    </message>
    <message>
        <source>Young&apos;s modulus</source>
        <translation>Module d’Young</translation>
    </message>
    <message>
        <source>Radius of the ball</source>
        <translation>Rayon de la boule</translation>
    </message>
    <message>
        <source>Thickness of the layer</source>
        <translation>Épaisseur de la couche</translation>
    </message>
    <message>
        <source>Bonded to what is below</source>
        <translation>Lié à ce qui est dessous</translation>
    </message>
    <message>
        <source>Stiffness before the click</source>
        <translation>Raideur avant le déclic</translation>
    </message>
    <message>
        <source>Force at which it gives way</source>
        <translation>Force à laquelle il cède</translation>
    </message>
    <message>
        <source>Force that it falls to</source>
        <translation>Force à laquelle il retombe</translation>
    </message>
    <message>
        <source>Depth over which it falls</source>
        <translation>Profondeur de la retombée</translation>
    </message>
    <message>
        <source>Stiffness after the click</source>
        <translation>Raideur après le déclic</translation>
    </message>
</context>
<context>
    <name>palpate::ui::TouchChart</name>
    <message>
        <source>Chart of force and depth over the last ten seconds</source>
        <translation>Courbe de force et profondeur sur les dix dernières secondes</translation>
    </message>
    <message>
        <source>Force [N] and depth [mm] over the last 10 s</source>
        <translation>Force [N] et profondeur [mm] sur les 10 dernières&#xa0;s</translation>
    </message>
    <message>
        <source>nothing was felt yet</source>
        <translation>rien senti encore</translation>
    </message>
    <message>
        <source>now %1 N, %2 mm deep; at most %3 N, %4 mm</source>
        <translation>à présent %1&#xa0;N, prof. %2&#xa0;mm&#x202f;; au plus %3&#xa0;N, %4&#xa0;mm</translation>
    </message>
    <message>
        <source>−10 s</source>
        <translation>−10&#xa0;s</translation>
    </message>
    <message>
        <source>−5 s</source>
        <translation>−5&#xa0;s</translation>
    </message>
    <message>
        <source>now</source>
        <translation>maintenant</translation>
    </message>
    <message>
        <source>Force [N]</source>
        <translation>Force [N]</translation>
    </message>
    <message>
        <source>Depth [mm]</source>
        <translation>Profondeur [mm]</translation>
    </message>
    <message>
        <source>along the surface</source>
        <translation>le long de la surface</translation>
    </message>
</context>
<context>
    <name>palpate::ui::TouchPanel</name>
    <message>
        <source>%1 N, %2 mm deep</source>
        <translation>%1&#xa0;N, prof. %2&#xa0;mm</translation>
    </message>
    <message>
        <source>%1 mm deep · slid off the edge</source>
        <translation>prof. %1&#xa0;mm · glissé hors du bord</translation>
    </message>
    <message>
        <source>%1 mm deep · %2 N/mm</source>
        <translation>prof. %1&#xa0;mm · %2&#xa0;N/mm</translation>
    </message>
    <message>
        <source>N</source>
        <translation>N</translation>
    </message>
    <message>
        <source>Force in newton</source>
        <translation>Force en newtons</translation>
    </message>
    <message>
        <source>Force on the hand [N]</source>
        <translation>Force sur la main [N]</translation>
    </message>
    <message>
        <source>Touched structure</source>
        <translation>Structure touchée</translation>
    </message>
    <message>
        <source>Touched structures, the outermost first, with their forces and depths</source>
        <translation>Structures touchées, la plus externe d’abord, avec forces et profondeurs</translation>
    </message>
    <message>
        <source>Depth and stiffness</source>
        <translation>Profondeur et raideur</translation>
    </message>
    <message>
        <source>Depth: from the outermost surface to the hand [mm]; stiffness as felt, of all layers that are touched [N/mm]</source>
        <translation>Profondeur&#x202f;: de la surface la plus externe à la main [mm]&#x202f;; raideur sentie, de toutes les couches touchées [N/mm]</translation>
    </message>
    <message>
        <source>More triangles of the mesh lie in this place than there is time to feel at once</source>
        <translation>Trop de triangles du maillage sont à cet endroit pour être tous sentis à temps</translation>
    </message>
    <message>
        <source>Not touching</source>
        <translation>Aucun contact</translation>
    </message>
    <message>
        <source>slid off the edge</source>
        <translation>glissé hors du bord</translation>
    </message>
    <message>
        <source>the hand is free</source>
        <translation>la main est libre</translation>
    </message>
    <message>
        <source>very fine mesh here: the force follows late</source>
        <translation>maillage très fin ici&#x202f;: la force suit avec retard</translation>
    </message>
    <message>
        <source>press on a structure to feel it</source>
        <translation>appuyer sur une structure pour la sentir</translation>
    </message>
    <message>
        <source>%1 in %2</source>
        <translation>%1 dans %2</translation>
    </message>
    <message>
        <source>Each layer that is touched, the outermost first: its part along the force [N], which add
up to it, and how deep the hand is in it [mm]</source>
        <translation>Chaque couche touchée, la plus externe d’abord&#x202f;: sa part le long de la force [N], dont
la somme la donne, et la profondeur de la main [mm]</translation>
    </message>
    <message>
        <source>over %1: %2, %3</source>
        <translation>sur %1&#x202f;: %2, %3</translation>
    </message>
    <message>
        <source>over %1: %2</source>
        <translation>sur %1&#x202f;: %2</translation>
    </message>
</context>
<context>
    <name>palpate::ui::TouchSound</name>
    <message>
        <source>no loudspeaker is there</source>
        <translation>aucun haut-parleur</translation>
    </message>
    <message>
        <source>%1 can&apos;t play it</source>
        <translation>%1 ne peut pas le jouer</translation>
    </message>
    <message>
        <source>built without Qt Multimedia</source>
        <translation>compilé sans Qt Multimedia</translation>
    </message>
</context>
<context>
    <name>palpate::ui::Tour</name>
    <message>
        <source>Back</source>
        <translation>Retour</translation>
    </message>
    <message>
        <source>End (Esc)</source>
        <translation>Finir (Échap)</translation>
    </message>
    <message>
        <source>%1 of %2: %3</source>
        <translation>%1 sur %2&#x202f;: %3</translation>
    </message>
    <message>
        <source>Done</source>
        <translation>Terminé</translation>
    </message>
    <message>
        <source>Next</source>
        <translation>Suivant</translation>
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
        <translation>tourner la caméra de 15°&#x202f;; avec Maj&#x202f;: la déplacer</translation>
    </message>
    <message>
        <source>+  −</source>
        <translation>+  −</translation>
    </message>
    <message>
        <source>zoom</source>
        <translation>zoomer</translation>
    </message>
    <message>
        <source>Ctrl+← → ↑ ↓</source>
        <translation>Ctrl+← → ↑ ↓</translation>
    </message>
    <message>
        <source>move the place to press by 2 mm along the screen</source>
        <translation>déplacer le point d’appui de 2&#xa0;mm dans le plan de l’écran</translation>
    </message>
    <message>
        <source>Enter</source>
        <translation>Entrée</translation>
    </message>
    <message>
        <source>press there, let go</source>
        <translation>y appuyer, lâcher</translation>
    </message>
    <message>
        <source>Page down  up</source>
        <translation>Page bas  haut</translation>
    </message>
    <message>
        <source>press deeper, less deep by 0.5 mm</source>
        <translation>appuyer plus, moins profond de 0,5&#xa0;mm</translation>
    </message>
</context>
<context>
    <name>palpate::ui::ViewVoice</name>
    <message>
        <source>3D view</source>
        <translation>Vue 3D</translation>
    </message>
    <message>
        <source>3D view: %1, %2</source>
        <translation>Vue 3D&#x202f;: %1, %2</translation>
    </message>
</context>
<context>
    <name>palpate::ui::WelcomePage</name>
    <message>
        <source>Try the phantom</source>
        <translation>Essayer le fantôme</translation>
    </message>
    <message>
        <source>Recent</source>
        <translation>Récents</translation>
    </message>
    <message>
        <source>Feel segmented anatomy</source>
        <translation>Palper l’anatomie segmentée</translation>
    </message>
    <message>
        <source>Drop surface meshes or a scene here: %1</source>
        <translation>Déposer ici maillages de surface ou scène&#x202f;: %1</translation>
    </message>
    <message>
        <source>Open anatomy…</source>
        <translation>Ouvrir une anatomie…</translation>
    </message>
    <message>
        <source>Open mesh or scene files (Ctrl+O)</source>
        <translation>Ouvrir maillages ou scène (Ctrl+O)</translation>
    </message>
    <message>
        <source>Open the phantom that comes with Palpate: a liver with two lumps, and a recorded palpation</source>
        <translation>Ouvrir le fantôme fourni avec Palpate&#x202f;: un foie avec deux nodules, et une palpation enregistrée</translation>
    </message>
    <message>
        <source>Then press P, drag to press, and set the depth with the wheel. Press ? for all keys.</source>
        <translation>Puis taper P, glisser pour appuyer, et régler la profondeur à la molette.&#x202f;? affiche les raccourcis.</translation>
    </message>
    <message>
        <source>or</source>
        <translation>ou</translation>
    </message>
</context>
</TS>
