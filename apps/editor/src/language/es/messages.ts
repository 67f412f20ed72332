import type { Texts } from '@farol/editing';

/** Spanish texts of notices, dialogs and errors. */
export const messages: Texts = {
  'There is no scene “{text}”: there are empty, {names}.': 'No hay ninguna escena «{text}»: existen empty, {names}.',
  'The scene': 'La escena',
  'Opening {file}': 'Abriendo {file}',
  'the scene': 'la escena',
  '{file} cannot be opened': 'No se puede abrir {file}',
  'The file': 'El archivo',
  'Nothing has changed. What is wrong with it:': 'No ha cambiado nada. Lo que falla:',
  'A large scene': 'Una escena grande',
  'The scene grows {sizes} when it is unpacked, which may take long or end this tab. Open it only if you know where it comes from.':
    'La escena crece {sizes} al desempaquetarla, lo que puede tardar mucho o cerrar esta pestaña. Conviene abrirla solo si se conoce su procedencia.',
  'Open it': 'Abrirla',
  'Unsaved changes': 'Cambios sin guardar',
  'This cannot be read': 'Esto no se puede leer',
  'These components are unknown, so they are kept as data: {names}. Add the plugin or script that has them.':
    'Falta lo que aporta estos componentes y se conservan como datos: {names}. Hay que añadir el complemento al que pertenecen.',
  'The picture cannot be drawn: {reason}': 'No se puede dibujar la imagen: {reason}',
  'The graphics device was lost. The picture comes back by itself; if not, save and reload.':
    'Se ha perdido el dispositivo gráfico. La imagen vuelve por sí sola; si no, hay que guardar y recargar.',
  'Farol cannot start': 'Farol no puede arrancar',
  'no object': 'ningún objeto',
  '{component} of {owner}: {reason}': '{component} de {owner}: {reason}',
  '{chunk}, line {line}: {message}': '{chunk}, línea {line}: {message}',
  shader: 'shader',
  'A shader does not compile: see the console.': 'Un shader no compila: véase la consola.',
  '{name} is a prefab: place it from Assets': '{name} es un prefab: se coloca desde Recursos',
  'There is nothing to recover: no tab was closed with unsaved work':
    'No hay nada que recuperar: ninguna pestaña se cerró con trabajo sin guardar',
  'Saved {name}': 'Guardado {name}',
  '“{name}” has changed': '«{name}» ha cambiado',
  'Another tab or program has written “{name}” since it was opened or saved here. To save over it loses what it holds now; under another name both are kept.':
    'Otra pestaña u otro programa ha escrito «{name}» desde que se abrió o guardó aquí. Guardar encima pierde lo que contiene ahora; con otro nombre se conservan los dos.',
  'Save over it': 'Guardar encima',
  ' and {count} more': ' y {count} más',
  '{name} asks for files of other hosts': '{name} pide archivos de otros servidores',
  'The hosts would learn that you open it, and when. Without them the rest of the scene opens. It loads:':
    'Sabrían que se abre, y cuándo. Sin ellos se abre el resto de la escena. Pide:',
  Hosts: 'Servidores',
  'there is no room left': 'no queda espacio',
  'Free space on the disk, or choose another place.': 'Hay que liberar espacio en el disco o elegir otro lugar.',
  'the browser may not write there any more': 'el navegador ya no puede escribir ahí',
  'Allow it when the browser asks, or choose another place.':
    'Hay que permitirlo cuando el navegador pregunte, o elegir otro lugar.',
  'the file or its folder is no longer there': 'el archivo o su carpeta ya no está',
  'Choose another place.': 'Hay que elegir otro lugar.',
  'another tab or program holds the file': 'otra pestaña o programa tiene abierto el archivo',
  'Close it there and save again, or choose another place.':
    'Hay que cerrarlo ahí y guardar de nuevo, o elegir otro lugar.',
  'the file has changed meanwhile': 'el archivo ha cambiado entretanto',
  'Save again, or choose another place.': 'Hay que guardar de nuevo o elegir otro lugar.',
  'the disk cannot be read': 'no se puede leer el disco',
  'the browser refused the file': 'el navegador rechazó el archivo',
  'Save again under another name.': 'Hay que guardar con otro nombre.',
  'the browser did not allow it': 'el navegador no lo permitió',
  'Save once more.': 'Hay que guardar otra vez.',
  'the browser gives no reason but {name}': 'el navegador no da más motivo que {name}',
  'Reading {name}': 'Leyendo {name}',
  'Reading {count} files': 'Leyendo {count} archivos',
  '{path} cannot be imported: {reason}': 'No se puede importar {path}: {reason}',
  '{names} cannot be imported: only {importable} can.': 'No se puede importar {names}: solo {importable}.',
  '{path} is a scene within a ZIP: unpack the ZIP, and open it by itself.':
    '{path} es una escena dentro de un ZIP: hay que descomprimir el ZIP y abrirla aparte.',
  '{scene} was opened by itself, without {names}: drop these again.':
    '{scene} se abrió sola, sin {names}: hay que soltarlos de nuevo.',
  'There is nothing to import: the folder or ZIP is empty.':
    'No hay nada que importar: la carpeta o el ZIP están vacíos.',
  'a chunk': 'un fragmento',
  '{file} is not imported, and nothing has changed: {reason}':
    '{file} no se ha importado y no ha cambiado nada: {reason}',
  '{file} replaces microshaders that are there': '{file} reemplaza microshaders que ya existen',
  'All that uses these microshaders changes; undo takes the import back. It replaces:':
    'Cambia lo que se dibuja con ellos. El historial deshace la importación en un paso. Reemplaza:',
  'of this scene': 'de esta escena',
  'built in, edited': 'incorporado, editado',
  'built in': 'incorporado',
  'Replace them': 'Reemplazarlos',
  '{file} is not imported: another scene was opened meanwhile.':
    '{file} no se ha importado: entretanto se abrió otra escena.',
  'This prefab is not in the scene any more.': 'Este prefab ya no está en la escena.',
  "{name} cannot be placed within itself: '{outer}' is, or holds, an instance of it.":
    '{name} no se puede colocar dentro de sí mismo: «{outer}» es, o contiene, una instancia suya.',
  '“{fileName}” was not saved: {why}. {mend}': '«{fileName}» no se ha guardado: {why}. {mend}',
  '“{name}” is included by {users}: change those first.': '«{name}» lo necesitan {users}: hay que cambiar antes esos.',
  'A microshader “{name}” exists already: choose another name.':
    'Ya hay un microshader «{name}»: hay que elegir otro nombre.',
  'This browser keeps no drafts here: {reason} Save to a file by Ctrl+S.':
    'Este navegador no guarda borradores aquí: {reason} Se puede guardar en un archivo con Ctrl+S.',
  'This browser keeps no drafts here since {time}: {reason} Save to a file by Ctrl+S.':
    'Este navegador no guarda borradores aquí desde las {time}: {reason} Se puede guardar en un archivo con Ctrl+S.',
  '{name} cannot be kept alone: its object was added while playing. Keep all edits.':
    '{name} no se puede conservar sola: su objeto se añadió durante la reproducción. Se pueden conservar todas las ediciones.',
  Pasting: 'Pegando',
  'What was copied': 'Lo copiado',
  '{name} could not be pasted: {reason}': 'No se ha podido pegar {name}: {reason}',
  'its file is no longer there. Copy it again, in a tab that has it open.':
    'su archivo ya no está. Hay que copiarlo de nuevo en una pestaña que lo tenga abierto.',
  'The clipboard holds no objects: copy some first.':
    'El portapapeles no contiene objetos: hay que copiar alguno antes.',
  "The plugin '{name}' cannot be added: there is {names} already. Choose other names.":
    'No se puede añadir el complemento «{name}»: ya existe {names}. Hay que elegir otros nombres.',
  'Added the plugin {name}': 'Complemento {name} añadido',
  "There is no plugin '{name}' to remove.": 'No hay ningún complemento «{name}» que quitar.',
  'The plugin {name} is removed': 'Complemento {name} quitado',
  'The plugin {name} is removed: {components} kept as data until the plugin is there again':
    'Complemento {name} quitado: {components} se conservan como datos hasta que vuelva',
  'The {type} of {name} is kept as data: {message}': '{type} de {name} queda como datos: {message}',
  'Microshaders of {name} stay, since others need them: {names}':
    'Los microshaders de {name} se quedan, porque otros los necesitan: {names}',
  'the plugin': 'el complemento',
  'the panel': 'el panel',
  'the action': 'la acción',
  'the component': 'el componente',
  'the type of fields': 'el tipo de campos',
  'the technique': 'la técnica',
  'the effect': 'el efecto',
  'the microshader': 'el microshader',
  '{name} is not here any more: another tab has recovered or discarded it.':
    '{name} ya no está aquí: otra pestaña la recuperó o la descartó.',
  '{name} is recovered. Save it to keep it.': '{name} está como estaba. Hay que guardarla para conservarla.',
  'Drafts are stored again.': 'Se vuelven a guardar borradores.',
  'The autosave could not be loaded: reload the page.':
    'No se pudo cargar el guardado automático: hay que recargar la página.',
  '{objects} object': '{objects} objeto',
  '{objects} objects': '{objects} objetos',
  'last edit: {edit}': 'última edición: {edit}',
  'it has no room left for this page; free space on the disk.':
    'no le queda espacio para esta página; hay que liberar espacio en el disco.',
  'it does not let this page store data, as in some private windows.':
    'no deja que esta página guarde nada, como en algunas ventanas privadas.',
  'its storage is closed, as in some private windows.': 'su almacén está cerrado, como en algunas ventanas privadas.',
  'its storage is of a newer version of Farol; reload the page.':
    'su almacén es de una versión más nueva de Farol; hay que recargar la página.',
  'its storage is damaged, or the disk is full.': 'su almacén está dañado o el disco está lleno.',
  'it has no IndexedDB, as in some private windows.': 'no tiene IndexedDB, como en algunas ventanas privadas.',
  'it has no Web Locks, which pages have only over https.':
    'no tiene Web Locks, que las páginas solo tienen por https.',
  ' The largest assets are {names}.': ' Los recursos más grandes son {names}.',
  'The link would have {size}, and {limit} is the limit.{why} Export a web page instead.':
    'El enlace ocuparía {size} y el máximo es {limit}.{why} Se puede exportar una página web.',
  '{label} came with Farol, and cannot be deleted.': '{label} viene con Farol y no se puede eliminar.',
  '{label} is a part of {model}: delete that.': '{label} es parte de {model}: se elimina con él.',
  'becomes an object of its own.': 'pasa a ser un objeto propio.',
  '{field} becomes empty.': '{field} queda vacío.',
  'Delete {label}?': '¿Eliminar {label}?',
  'It is used in {count} place. The step can be undone.': 'Se usa en {count} lugar. El paso se puede deshacer.',
  'It is used in {count} places. The step can be undone.': 'Se usa en {count} lugares. El paso se puede deshacer.',
  'Exported {fileName}': 'Exportado {fileName}',
  '{label} copied': '{label}: copiado',
  'Imported {count} microshader of {name}': 'Importado {count} microshader de {name}',
  'Imported {count} microshaders of {name}': 'Importados {count} microshaders de {name}',
  '{file}: the server answers {status}; serve the folder public/ too.':
    '{file}: el servidor responde {status}; hay que servir también la carpeta public/.',
  'Exported {count} microshader': 'Exportado {count} microshader',
  'Exported {count} microshaders': 'Exportados {count} microshaders',
  'Materials brighter than white became white': 'Los materiales más brillantes que el blanco pasaron a blanco',
  'Maps that glTF does not have are left out': 'Se omiten los mapas que glTF no tiene',
  'Textures on meshes without texture coordinates are left out':
    'Se omiten las texturas de mallas sin coordenadas de textura',
  'Shaders became plain grey': 'Los shaders pasaron a gris liso',
  'Phong and Lambert materials became rough ones': 'Los materiales Phong y Lambert pasaron a rugosos',
  'Hidden objects are left out': 'Se omiten los objetos ocultos',
  'Components that glTF does not know are left out: {typeName}':
    'Se omiten los componentes que glTF no conoce: {typeName}',
  'Meshes that are not loaded are left out': 'Se omiten las mallas sin cargar',
  'Meshes whose arrays were freed are left out': 'Se omiten las mallas cuyos arrays se liberaron',
  'Models that are not loaded are left out': 'Se omiten los modelos sin cargar',
  'Lights from all sides are left out': 'Se omiten las luces de todas direcciones',
  'The environment is left out': 'Se omite el entorno',
  'The background is left out': 'Se omite el fondo',
  'Fog is left out': 'Se omite la niebla',
  'the browser has no canvas left to draw it on: close other pages and try again.':
    'el navegador no da ningún lienzo donde dibujarla: hay que cerrar otras páginas y probar de nuevo.',
  'A texture': 'Una textura',
  '{name} of {user} cannot be exported: {reason}': 'No se puede exportar {name} de {user}: {reason}',
  'it has no picture: load it again, or choose another.': 'no tiene imagen: hay que cargarla de nuevo o elegir otra.',
  'the graphics device was lost: export again when the picture is back.':
    'se perdió el dispositivo gráfico: hay que exportar de nuevo cuando vuelva la imagen.',
  '{name} is locked: unlock it to move it.': '{name} está bloqueado: hay que desbloquearlo para moverlo.',
  '{name} is below {parent}, which is scaled unevenly: scale it evenly to move the camera.':
    '{name} está dentro de {parent}, que tiene una escala desigual: hay que igualarla para mover la cámara.',
  'The scene plays: stop it to move this camera.':
    'La escena se está reproduciendo: hay que detenerla para mover esta cámara.',
  '{name} stays where it is: it came with Farol, or is a part of a model.':
    '{name} se queda donde está: viene con Farol o es parte de un modelo.',
  '{label} keeps its name: it came with Farol, or is a part of a model.':
    '{label} conserva su nombre: viene con Farol o es parte de un modelo.',
  'No object uses {name}.': 'Ningún objeto usa {name}.',
  'a skeleton': 'un esqueleto',
  'morph targets': 'formas de mezcla',
  'instances of a mesh': 'instancias de una malla',
  'points or lines': 'puntos o líneas',
  '{name} stays one object: it has {what}, which only a whole model keeps.':
    '{name} se queda como un solo objeto: tiene {what}, que solo conserva un modelo entero.',
  'parts of a model': 'partes de un modelo',
  'These exist already, with the same content: {names}.': 'Ya está, con el mismo contenido: {names}.',
  '{objects} stays linked to the model, as one object with its clips: it has {what}.':
    '{objects} sigue enlazado al modelo, como un solo objeto con sus animaciones: tiene {what}.',
  '{objects} stay linked to the model, each as one object with its clips: they have {what}.':
    '{objects} siguen enlazados al modelo, cada uno como un solo objeto con sus animaciones: tienen {what}.',
  'Farol scene': 'Escena de Farol',
  'cannot be edited: make a new material.': 'no se puede editar: hay que crear un material nuevo.',
  'needs a name.': 'necesita un nombre.',
  'is there already: choose another name.': 'ya existe: hay que elegir otro nombre.',
  'cannot be put into itself: choose another folder.':
    'no se puede poner dentro de sí misma: hay que elegir otra carpeta.',
  'holds an asset: move or delete it first.': 'contiene un recurso: hay que moverlo o eliminarlo antes.',
  'holds {count} assets: move or delete them first.':
    'contiene {count} recursos: hay que moverlos o eliminarlos antes.',
  'Techniques cannot be compared: this device cannot draw to float colour buffers (EXT_color_buffer_float).':
    'No se pueden comparar técnicas: este dispositivo no dibuja en búferes de color flotantes (EXT_color_buffer_float).',
  '“{name}” has changes that are not saved. Save them before it is closed?':
    '«{name}» tiene cambios sin guardar. ¿Guardarlos antes de cerrarla?',
  'Don’t save': 'No guardar',
};
