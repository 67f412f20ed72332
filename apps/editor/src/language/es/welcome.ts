import type { Texts } from '@farol/editing';

/** Spanish texts of the welcome page and the tour. */
export const welcome: Texts = {
  'Leave the tour': 'Salir del recorrido',
  '{step} of {steps}': '{step} de {steps}',
  Done: 'Hecho',
  Next: 'Siguiente',
  'The picture': 'La imagen',
  'Drag to turn it, wheel to come nearer, Shift and drag to shift it. Hold the right button to look around, and W A S D to fly. By touch: one finger turns, two shift and zoom.':
    'Arrastrar la gira, la rueda la acerca, Mayús y arrastrar la desplaza. Con el botón derecho se mira alrededor, y con W A S D se vuela. Con los dedos: uno gira, dos desplazan y acercan.',
  'Add things': 'Añadir cosas',
  'Meshes, lights, cameras and decals. What you add is selected, and one step back by Ctrl+Z.':
    'Mallas, luces, cámaras y calcomanías. Lo que se añade queda seleccionado, y Ctrl+Z lo deshace en un paso.',
  'Move, rotate, scale': 'Mover, rotar, escalar',
  'Click something in the picture, then W moves it, E rotates it, R scales it. Hold Ctrl to snap.':
    'Con un clic en algo de la imagen, W lo mueve, E lo rota y R lo escala. Con Ctrl se ajusta.',
  'Everything in the scene. Drag a line onto another to attach it, F2 renames, H hides, L locks.':
    'Todo lo que hay en la escena. Una línea se arrastra sobre otra para unirla; F2 renombra, H oculta, L bloquea.',
  'Every value of what is selected. Drag sideways on a number, or type it. Add component gives it more.':
    'Todos los valores de lo seleccionado. Un número se arrastra hacia los lados o se escribe. «Añadir componente» le da más.',
  'Models, textures and materials. Drop files anywhere on the window, and drag from here into the picture.':
    'Modelos, texturas y materiales. Los archivos se sueltan en cualquier lugar de la ventana, y de aquí se arrastran a la imagen.',
  'How the lights are drawn: the same picture at different speeds. View > Technique has them too.':
    'Cómo se dibujan las luces: la misma imagen a distintas velocidades. También están en Vista > Técnica.',
  'Runs the scene. Stop puts everything back; what you changed meanwhile can be kept, value by value.':
    'Ejecuta la escena. Detener deja todo como estaba; lo que se cambió entretanto se puede conservar, valor a valor.',
  'Everything that can be done, with its key. File saves, exports and shares; Ctrl+K finds any command by name.':
    'Todo lo que se puede hacer, con su tecla. Archivo guarda, exporta y comparte; Ctrl+K encuentra cualquier orden por su nombre.',
  'Recent files': 'Archivos recientes',
  'Opened or saved {time}': 'Abierto o guardado: {time}',
  'Forget {name}': 'Olvidar {name}',
  'Take it out of this list; the file stays': 'Quitarlo de esta lista; el archivo se queda',
  Samples: 'Ejemplos',
  'Welcome to Farol': 'Bienvenida a Farol',
  'Scenes with very many lights, in the browser.': 'Escenas con muchísimas luces, en el navegador.',
  'A camera, a sun and a sky': 'Una cámara, un sol y un cielo',
  'Open a scene…': 'Abrir una escena…',
  'A .farol file': 'Un archivo .farol',
  'Drop a model here': 'Soltar aquí un modelo',
  'glTF, OBJ, STL… or choose files': 'glTF, OBJ, STL… o elegir archivos',
  'Choose files of a model': 'Elegir los archivos de un modelo',
  'Two-minute tour': 'Recorrido de dos minutos',
  'Leave it at any step': 'Se puede salir en cualquier paso',
  'Show at start': 'Mostrar al empezar',
  'Go on with “{scene}”': 'Seguir con «{scene}»',
  'Unsaved work was found: “Recover…” in the menu File brings it back.':
    'Hay trabajo sin guardar: «Recuperar…», en el menú Archivo, lo trae de vuelta.',
  'choose it by Open… in the menu File.': 'se elige con Abrir…, en el menú Archivo.',
  '{name} was too large for a copy: {mend}': '{name} era demasiado grande para una copia: {mend}',
  'The browser has no permission to read {name}: {mend}': 'El navegador no puede leer {name}: {mend}',
  '{name} is no longer where it was: {mend}': '{name} ya no está donde estaba: {mend}',
};
