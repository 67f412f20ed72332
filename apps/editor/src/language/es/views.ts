import type { Texts } from '@farol/editing';

/** Spanish texts of views, cameras and keyboard input to a playing scene. */
export const views: Texts = {
  'View {place}': 'Vista {place}',
  'Keep view {place}': 'Conservar la vista {place}',
  'Name of the view': 'Nombre de la vista',
  'View {place}: empty': 'Vista {place}: no hay ninguna conservada',
  'Keep this view as {place}': 'Conservar esta vista como {place}',
  Perspective: 'Perspectiva',
  'Keys go to the scene. Esc gives them back.': 'Las teclas van a la escena. Esc las devuelve.',
  "Keys are the editor's. Press the picture to give them to the scene.":
    'Las teclas son del editor. Con un clic en la imagen pasan a la escena.',
  'You fly {name}: drag, wheel, arrow keys, and W A S D while the right button is held.':
    'Se vuela {name}: arrastrar, rueda, flechas, y W A S D con el botón derecho pulsado.',
  'Keep this view': 'Conservar esta vista',
  'Rename a view': 'Renombrar una vista',
  'Forget a view': 'Olvidar una vista',
  'Views and cameras': 'Vistas y cámaras',
  'Saved views': 'Vistas guardadas',
  'Four views': 'Cuatro vistas',
  'Next view': 'Vista siguiente',
  'Bring the other views to where this one looks': 'Llevar las demás vistas adonde mira esta',
  "As the scene's technique lights it": 'Como la ilumina la técnica de la escena',
  'Unlit colours': 'Colores sin luz',
  Clay: 'Arcilla',
  'Debug view': 'Vista de depuración',
  'Share of the sky that is open over each pixel: white is all of it.':
    'Parte del cielo abierta sobre cada píxel: blanco es todo.',
  'Motion of each pixel since the last frame: colour is direction, brightness length.':
    'Recorrido de cada píxel desde el último fotograma: el color es la dirección y el brillo, la longitud.',
  'Full colour: {pixels} pixels a frame and more': 'Color pleno: {pixels} píxeles por fotograma o más',
  'Pixels whose history TAA ignores, since particles cover them.':
    'Píxeles cuyo pasado TAA no usa, porque los cubren partículas.',
  'Sums of light on each pixel, before materials give them their colours.':
    'Sumas de luz en cada píxel, antes de que los materiales les den color.',
  'Shadow maps of all lights as they lie in one texture: near is black, far white.':
    'Los mapas de sombra de todas las luces tal como están en una textura: negro es cerca y blanco, lejos.',
  'Images and profiles of lights as they lie in one texture.':
    'Imágenes y perfiles de las luces tal como están en una textura.',
  'Light that fog sends to the eye, from what lies before each surface.':
    'Luz que la niebla envía al ojo, desde delante de cada superficie.',
  'Share of light that fog lets through from each surface to the eye: white is all of it.':
    'Parte de la luz que la niebla deja pasar de cada superficie al ojo: blanco es toda.',
  'Light in the fog, slice by slice: from the eye (upper left) to where the fog ends.':
    'Luz en la niebla, capa por capa: desde el ojo (arriba a la izquierda) hasta donde la niebla acaba.',
  'Point at a part to see what it is.': 'Al señalar una parte se ve qué es.',
  Image: 'Imagen',
  'Photometric profile': 'Perfil fotométrico',
  'Diffuse light': 'Luz difusa',
  'Specular light': 'Luz especular',
  'Specular light at grazing angles': 'Luz especular en ángulos rasantes',
  'Ambient light of lamps, area lights': 'Luz ambiental de las lámparas, luces de área',
  'Shadow map, {near} to {far} m': 'Mapa de sombra, de {near} a {far} m',
  'Shadow map, face {number} of {count}, {near} to {far} m':
    'Mapa de sombra, cara {number} de {count}, de {near} a {far} m',
  'Shadow map, cascade {number} of {count}, {near} to {far} m':
    'Mapa de sombra, cascada {number} de {count}, de {near} a {far} m',
  'Slice {number} of {count}, {near} to {far} m': 'Capa {number} de {count}, de {near} a {far} m',
  'Choose the technique by itself': 'Elegir la técnica automáticamente',
  'Switch ambient occlusion on': 'Activar la oclusión ambiental',
  'Switch TAA on': 'Activar TAA',
  'Draw by Light pre-pass': 'Dibujar con Light pre-pass',
  'Switch volumetric fog on': 'Activar la niebla volumétrica',
  'Choose the shading…': 'Elegir el sombreado…',
  'Play from the camera': 'Reproducir desde la cámara',
  'Play from here': 'Reproducir desde aquí',
  'Edge between the views at the left and at the right': 'Borde entre las vistas de la izquierda y la derecha',
  'Edge between the views above and below': 'Borde entre las vistas de arriba y abajo',
  'Corner between the four views': 'Esquina entre las cuatro vistas',
};
