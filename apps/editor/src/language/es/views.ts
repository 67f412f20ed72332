import type { Texts } from '@farol/editing';

/** Spanish texts of views, cameras and keys of a playing scene. */
export const views: Texts = {
  'View {place}': 'Vista {place}',
  'Keep view {place}': 'Conservar la vista {place}',
  'Name of the view': 'Nombre de la vista',
  'View {place}: none is kept': 'Vista {place}: no hay ninguna conservada',
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
  'Choose the shading…': 'Elegir el sombreado…',
  'Play from the camera': 'Reproducir desde la cámara',
  'Play from here': 'Reproducir desde aquí',
  'Edge between the views at the left and at the right': 'Borde entre las vistas de la izquierda y la derecha',
  'Edge between the views above and below': 'Borde entre las vistas de arriba y abajo',
  'Corner between the four views': 'Esquina entre las cuatro vistas',
};
