import type { MessageTable } from '../messageTable';

/** Spanish translations of the engine's most common messages; messages that contain others come first. */
export const engine: MessageTable = {
  // assets
  "The asset '{name}' could not be loaded: {reason}": "No se pudo cargar el recurso '{name}': {reason}",
  "The asset '{name}' is not in the library any more: choose another one.":
    "El recurso '{name}' ya no existe: hay que elegir otro.",
  "The asset '{name}' came with Farol, and keeps its name: choose one of your own.":
    "El recurso '{name}' viene con Farol y conserva su nombre: hay que elegir uno propio.",
  "The asset '{name}' is there already: choose another name.":
    "El recurso '{name}' ya existe: hay que elegir otro nombre.",
  "The asset '{name}' is unknown: register it first, or choose one of {names}":
    "No hay ningún recurso '{name}': hay que importarlo antes, o elegir uno de {names}",
  "The asset '{name}' cannot be read: only {endings} can. Convert it to one of them.":
    "El recurso '{name}' no se puede leer: solo {endings}. Hay que convertirlo a uno de ellos.",
  "The asset '{name}' was not fetched: {origin} is not allowed. Open the scene again and allow it.":
    "El recurso '{name}' no se descargó: {origin} no está permitido. Hay que abrir la escena de nuevo y permitirlo.",
  "The prefab '{name}' would hold itself, by its object '{object}': take that one out, or unpack it.":
    "El prefab '{name}' se contendría a sí mismo, por su objeto '{object}': hay que sacarlo, o desempaquetarlo.",
  // errors of files
  'the file is empty: choose it again.': 'el archivo está vacío: hay que elegirlo de nuevo.',
  'its bytes are not PNG, JPEG or WebP: was another file renamed?':
    'sus bytes no son PNG, JPEG ni WebP: ¿se cambió el nombre de otro archivo?',
  'its bytes are {format}, not {wanted}: was another file renamed?':
    'sus bytes son {format}, no {wanted}: ¿se cambió el nombre de otro archivo?',
  'it begins as {format}, and is damaged or cut short': 'empieza como {format}, y está dañado o cortado',
  'its glTF data are damaged or cut short ({reason}): export it again.':
    'sus datos glTF están dañados o cortados ({reason}): hay que exportarlo de nuevo.',
  "three's loader cannot read it ({reason}): export it again.":
    'el cargador de three no puede leerlo ({reason}): hay que exportarlo de nuevo.',
  'its FBX data cannot be read ({reason}): export it again as FBX 7.4, or as glTF.':
    'sus datos FBX no se pueden leer ({reason}): hay que exportarlo de nuevo como FBX 7.4, o como glTF.',
  'it is cut short (its header says {length} bytes, and it has {found}): export it again.':
    'está cortado (su cabecera dice {length} bytes, y tiene {found}): hay que exportarlo de nuevo.',
  'it is cut short ({length} bytes are less than a GLB header): export it again.':
    'está cortado ({length} bytes no son una cabecera GLB entera): hay que exportarlo de nuevo.',
  'it is cut short: export it again.': 'está cortado: hay que exportarlo de nuevo.',
  "it is not a glTF, whose 'asset' is missing: choose another file.":
    "no es un glTF, le falta la entrada 'asset': hay que elegir otro archivo.",
  'it is glTF {version}, and only glTF 2.x can be read: convert it.':
    'es glTF {version}, y solo se puede leer glTF 2.x: hay que convertirlo.',
  'its JSON cannot be read ({reason}): export it again.':
    'su JSON no se puede leer ({reason}): hay que exportarlo de nuevo.',
  'it needs {files}: drop the whole folder, or all of its files together.':
    'necesita {files}: hay que soltar la carpeta entera, o todos sus archivos juntos.',
  'it needs {file}: choose both files together.': 'necesita {file}: hay que elegir los dos archivos juntos.',
  'it cannot be decoded: convert it to MP3, Ogg or WAV.':
    'no se puede decodificar: hay que convertirlo a MP3, Ogg o WAV.',
  'it would take {memory} MB once it is decoded ({minutes} minutes), and {limit} MB is the limit: make it shorter.':
    'ocuparía {memory} MB una vez decodificado ({minutes} minutos), y {limit} MB es el límite: hay que acortarlo.',
  'it has no vertices: it is empty, or not an OBJ file. Export it again.':
    'no tiene vértices: no es un archivo OBJ, o está vacío. Hay que exportarlo de nuevo.',
  'it has no triangles: it is empty, or not an STL file. Export it again.':
    'no tiene triángulos: no es un archivo STL, o está vacío. Hay que exportarlo de nuevo.',
  'the PLY data are damaged or cut short: export it again':
    'los datos PLY están dañados o cortados: hay que exportarlos de nuevo',
  'the data are not a PLY file, which begins with "ply": choose another file':
    'los datos no son un archivo PLY, que empieza por «ply»: hay que elegir otro archivo',
  'it is damaged, or not a file of baked light: bake the light again.':
    'está dañado, o no es un archivo de luz precalculada: hay que calcular la luz de nuevo.',
  'Export it again from where it was made.': 'Hay que exportarlo de nuevo desde donde se hizo.',
  // addresses
  '{address} cannot be reached': 'no se llega a {address}',
  'check the address.': 'hay que revisar la dirección.',
  // scenes
  'The file is not JSON: {reason}. Choose a scene that was saved by Farol.':
    'El archivo no es JSON: {reason}. Hay que elegir una escena guardada por Farol.',
  'format must be "farol-scene", not {value}.': 'format debe ser "farol-scene", no {value}.',
  'version is {version}, but this Farol reads files up to version {newest}: update Farol.':
    'version es {version}, pero este Farol lee archivos hasta la versión {newest}: hay que actualizar Farol.',
  'it is not text': 'no es texto',
  // physics
  'The Collider of {object} has no mesh to fit to: give the object a mesh, or switch "Fit to mesh" off and give a size.':
    'El Collider de {object} no tiene malla a la que ajustarse: hay que dar una malla al objeto, o desactivar «Ajustar a la malla» y dar un tamaño.',
  'The Collider of {object} is a mesh on a dynamic body: choose the convex hull, or make the body fixed or kinematic.':
    'El Collider de {object} es una malla en un cuerpo dinámico: hay que elegir la envolvente convexa, o hacer el cuerpo fijo o cinemático.',
  'The Collider of {object} has no size, since its object, or one above it, has a scale of 0: set another.':
    'El Collider de {object} no tiene tamaño: su objeto, o uno que lo contiene, tiene una escala de 0. Hay que poner otra.',
  "The Joint of '{object}' has no body: add a RigidBody to its object, or to one above it.":
    "El Joint de '{object}' no tiene cuerpo: hay que añadir un RigidBody a su objeto, o a uno que lo contiene.",
  "The partner of the Joint of '{object}' is gone: choose another object, or none for the world.":
    "El otro objeto del Joint de '{object}' ya no existe: hay que elegir otro, o ninguno para el mundo.",
  "'{object}' has a CharacterController, which is a body of its own: remove the RigidBody.":
    "'{object}' tiene un CharacterController, que ya es un cuerpo: hay que quitar el RigidBody.",
  'Physics could not be fetched: {reason} Check the connection and play again.':
    'No se pudo descargar la física: {reason} Hay que comprobar la conexión y reproducir de nuevo.',
  // scripts
  'it exports no class: write `export default class … extends component({ … })`.':
    'no exporta ninguna clase: hay que escribir `export default class … extends component({ … })`.',
  'its default export is not a component class: write `export default class … extends component({ … })`.':
    'su exportación por defecto no es una clase de componentes: hay que escribir `export default class … extends component({ … })`.',
  'A loop has gone on for {seconds} s: give it an end, or do its work over several frames.':
    'Un bucle dura más de {seconds} s: hay que darle un final, o repartir su trabajo en varios fotogramas.',
  'it is still being loaded: wait for it.': 'todavía se está leyendo.',
  // clips
  "The clip '{name}': {problem}": "La animación '{name}': {problem}",
  'the object {object} is gone: give an object below this name, or choose another clip.':
    'el objeto {object} ya no existe: hay que dar ese nombre a un objeto, o elegir otra animación.',
  'it is gone: choose another clip.': 'ya no existe: hay que elegir otra animación.',
  "Animation.play: there is no clip '{name}'; there are {names}":
    "Animation.play: '{name}' no es una animación; hay {names}",
  // structure
  "'{object}' cannot be put below itself: choose a parent that is not among its children.":
    "'{object}' no se puede poner debajo de sí mismo: hay que elegir un padre que no esté entre sus hijos.",
  "'{object}' has a {component} already: change that one, or remove it first.":
    "'{object}' ya tiene un {component}: hay que cambiar ese, o quitarlo antes.",
};
