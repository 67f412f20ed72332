import type { Texts } from '@farol/editing';
import { es as editing, esOfApps } from '@farol/editing/es';

/** Spanish of texts that the editor has too, in the same words. */
const shared: Texts = {
  ...editing,
  ...esOfApps,
  Evening: 'Atardecer',
  'A low sun that casts shadows, a sky at sunset and tone mapping, in place of even light.':
    'Un sol bajo que proyecta sombras, un cielo al atardecer y mapeo de tonos, en vez de luz uniforme.',
};

/** All texts of the viewer in Spanish, by their English texts. */
export const es: Texts = {
  ...shared,
  'Scene {name}: {problem}': 'Escena {name}: {problem}',
  'The model is being read. Escape cancels.': 'Se está leyendo el modelo. Escape lo cancela.',
  'Shown instead: {name}.': 'En su lugar se muestra {name}.',
  'Farol viewer': 'Visor de Farol',
  'Farol cannot start: {reason}': 'Farol no puede empezar: {reason}',
  'The scene has no object {name}: drop the model once more.':
    'La escena no tiene ningún objeto {name}: hay que soltar el modelo otra vez.',
  'nothing that is a file': 'nada que sea un archivo',
  'there is no .glb, .gltf, .obj, .stl or .ply among {names}: choose one.':
    'no había ningún .glb, .gltf, .obj, .stl ni .ply entre {names}: hay que elegir uno.',
  'the browser cannot read it: it has more than 2 GB, or it was moved or changed; choose it again.':
    'el navegador no lo puede leer: pasa de 2 GB, o se movió o cambió; hay que elegirlo de nuevo.',
  'it needs {names}: drop the whole folder, or all of its files together.':
    'necesita {names}: hay que soltar la carpeta entera, o todos sus archivos a la vez.',
  '{name}: its scene has no mesh, so there is nothing to see: choose another file.':
    '{name}: su escena no tiene ninguna malla, no hay nada que ver: hay que elegir otro archivo.',
  'The picture would have {size} pixels. It is drawn with {fitted}: this device draws {side} a side, and the viewer {most} million in all.':
    'La imagen tendría {size} píxeles. Se dibuja con {fitted}: este dispositivo dibuja {side} por lado, y el visor {most} millones en total.',
  '{name}={text} in the address: {problem} The default is used.':
    '{name}={text} en la dirección: {problem} Se usa el valor por defecto.',
  '{name} is in the address {count} times: the first counts.':
    '{name} está {count} veces en la dirección: cuenta la primera.',
  '{name} in the address is unknown and left out.': '{name} en la dirección es desconocido y se omite.',
  'A name of no letters': 'Un nombre sin letras',
  'So are {count} others.': 'Y otros {count}.',
  'Known are {names}.': 'Se conocen {names}.',
  'it is unknown. Choose one of {names}.': 'es desconocido. Se conocen {names}.',
  ' from {min} to {max}': ' de {min} a {max}',
  ' of {min} or more': ' de {min} o más',
  'a whole number{range} is needed.': 'hace falta un número entero{range}.',
  'a number{range} is needed.': 'hace falta un número{range}.',
  '1 or 0 is needed.': 'hace falta 1 o 0.',
  'three numbers with commas between them are needed.': 'hacen falta tres números separados por comas.',
  'it does not fit into an address.': 'no cabe en una dirección.',
  'W A S D, arrows': 'W A S D, flechas',
  'fly forward, left, back, right; with Shift faster':
    'volar adelante, a la izquierda, atrás, a la derecha; con Mayús más rápido',
  'rise, sink': 'subir, bajar',
  'Drag##pointer': 'Arrastrar',
  'look round': 'mirar alrededor',
  Touch: 'Dedos',
  'orbit with one finger, zoom and pan with two': 'orbitar con un dedo; acercar y desplazar con dos',
  'stop and go': 'parar y seguir',
  'show or hide the menu': 'mostrar u ocultar el menú',
  'this help': 'esta ayuda',
  'Drop a .glb, .gltf, .obj, .stl, .ply, folder or .zip':
    'Soltar un .glb, .gltf, .obj, .stl, .ply, una carpeta o un .zip',
  'show that model': 'mostrar ese modelo',
  'Keys and address parameters (?)': 'Teclas y parámetros de la dirección (?)',
  'Bytes of surfaces and shadows: {names}; auto is lite on phones and weak devices.':
    'Bytes de superficies y sombras: {names}; auto es lite en teléfonos y equipos modestos.',
  'Anti-aliasing: {names}. TAA gathers over frames: at a fixed time each draw is one.':
    'Antialiasing: {names}. TAA acumula fotogramas: con un tiempo fijo, cada dibujo es uno.',
  '1 or 0.': '1 o 0.',
  '1 throws decals on the scene, with techniques that have a G-buffer.':
    '1 proyecta calcomanías sobre la escena, con técnicas que tienen G-buffer.',
  'So many particles in the scene, each of them a light of 0.5 m. 0 to 200000.':
    'Cuántas partículas hay en la escena; cada una es una luz de 0.5 m. De 0 a 200000.',
  'So many rectangle lights in the scene, each up to 1.5 m. 0 to 20000.':
    'Cuántas luces rectangulares hay en la escena, de hasta 1.5 m cada una. De 0 a 20000.',
  'Draws the scene once, as it is at this time (s), and does not move it.':
    'Dibuja la escena una vez, como está en ese momento (s), y no la mueve.',
  'Size of the picture (CSS pixels); the window by default.':
    'Tamaño de la imagen (píxeles CSS); por defecto, el de la ventana.',
  'Device pixels for each CSS pixel; those of the screen by default, 2 at most.':
    'Píxeles del dispositivo por píxel CSS; por defecto los de la pantalla, 2 como mucho.',
  'Whether slow frames are drawn smaller and enlarged: auto (on touch screens), on or off.':
    'Si los fotogramas lentos se dibujan más pequeños y se amplían: auto (en pantallas táctiles), on u off.',
  '0 hides the menu.': '0 oculta el menú.',
  '{min} to {max}.': 'De {min} a {max}.',
  '{min} or more.': '{min} o más.',
  'Close this message': 'Cerrar este mensaje',
  Stopped: 'Parado',
  '{rate} frames a second': '{rate} fotogramas por segundo',
  '{visible} of {total} lights in view': '{visible} de {total} luces a la vista',
  '{draws} draws, {triangles} triangles': '{draws} llamadas de dibujo, {triangles} triángulos',
  '{programs} programs, {size} MiB of targets': '{programs} programas, {size} MiB de destinos',
  'Whether slow frames are drawn smaller and enlarged.':
    'Si los fotogramas lentos se dibujan más pequeños y se amplían.',
  'Decals thrown on the scene; they need a technique with a G-buffer.':
    'Calcomanías proyectadas sobre la escena; necesitan una técnica con G-buffer.',
  'Particles in the scene, each of them a light of 0.5 m.': 'Partículas de la escena; cada una es una luz de 0.5 m.',
  'Rectangle lights': 'Luces rectangulares',
  'Lights that shine from rectangles in the scene, each up to 1.5 m.':
    'Luces que alumbran desde rectángulos de la escena, de hasta 1.5 m cada una.',
  'Stop time': 'Parar el tiempo',
  'Opens it in the Lab: how long each technique takes for it on this machine.':
    'La abre en el Lab: cuánto tarda cada técnica con ella en este equipo.',
  Scenes: 'Escenas',
  'Open a model…': 'Abrir un modelo…',
  'A .glb, .gltf, .obj, .stl, .ply or .zip, chosen together with the files that it names.':
    'Un .glb, .gltf, .obj, .stl, .ply o .zip, elegido junto con los archivos que nombra.',
  'Open a folder…': 'Abrir una carpeta…',
  'A folder with a model in it, and with what that names.': 'Una carpeta con un modelo y con lo que este nombra.',
  'Lights and sizes': 'Luces y tamaños',
  'Last frame': 'Último fotograma',
  'The graphics device was lost. The picture comes back by itself; if it does not, reload the page.':
    'Se perdió el dispositivo gráfico. La imagen vuelve sola; si no vuelve, hay que recargar la página.',
  'Moving point lights in a ring round the model.': 'Luces puntuales en movimiento, en un anillo alrededor del modelo.',
  'Another number, other paths of the lights.': 'Con otro número, otros recorridos de las luces.',
  Decals: 'Calcomanías',
  'Moving point lights.': 'Luces puntuales en movimiento.',
  'Meshes throw and receive shadows, in suns, spot lights and a few point lights.':
    'Las mallas proyectan y reciben sombras con soles, focos y unas pocas luces puntuales.',
  'Another number, other paths and colours of the lights.': 'Con otro número, otros recorridos y colores de las luces.',
  'Texture size': 'Tamaño de las texturas',
  'Width of the generated textures in texels.': 'Ancho de las texturas generadas, en téxeles.',
  'How many of the lights cast shadows (six faces of 512 texels each).':
    'Cuántas de las luces proyectan sombras (seis caras de 512 téxeles cada una).',
  'Sun casts shadows': 'El sol proyecta sombras',
  'Whether the sun casts shadows.': 'Si el sol proyecta sombras.',
  'Lights at rest': 'Luces en reposo',
  'The lights stand still, so that their shadow maps are kept.':
    'Las luces no se mueven, así que sus mapas de sombra se conservan.',
  'Moving point lights besides the three.': 'Luces puntuales en movimiento, además de las tres.',
  'Planes (N)': 'Planos (N)',
  'Planes from left to right.': 'Planos de izquierda a derecha.',
  'Planes in depth': 'Planos en profundidad',
  'Planes from front to back; 0: as many as N.': 'Planos de delante a atrás; 0: tantos como N.',
  'Lights (M)': 'Luces (M)',
  'Lights from left to right.': 'Luces de izquierda a derecha.',
  'Lights in depth': 'Luces en profundidad',
  'Lights from front to back; 0: as many as M.': 'Luces de delante a atrás; 0: tantas como M.',
  'Meshes (N)': 'Mallas (N)',
  'Meshes from left to right.': 'Mallas de izquierda a derecha.',
  'Meshes in depth': 'Mallas en profundidad',
  'Meshes from front to back; 0: as many as N.': 'Mallas de delante a atrás; 0: tantas como N.',
  'The mesh.': 'La malla.',
  Editor: 'Editor',
  Why: 'Por qué',
};
