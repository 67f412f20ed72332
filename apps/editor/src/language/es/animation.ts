import type { Texts } from '@farol/editing';

/** Spanish texts of the component Animation, of clips, and of clips exported as glTF. */
export const animation: Texts = {
  Animation: 'Animación',
  'Plays clips on the object and all below it.': 'Reproduce clips en el objeto y en todo lo que contiene.',
  'What it plays: a clip of a model, or one of your own.': 'Lo que reproduce: un clip de un modelo, o uno propio.',
  'Play on start': 'Reproducir al empezar',
  'Whether it plays as soon as the scene does.': 'Si se reproduce en cuanto lo hace la escena.',
  'At its end': 'Al final',
  'It stays there, begins again, or goes back the way it came.':
    'Se queda ahí, vuelve a empezar, o regresa por donde vino.',
  Stay: 'Quedarse',
  Loop: 'Bucle',
  'Ping-pong': 'Vaivén',
  'Start time': 'Tiempo inicial',
  'Where in the clip it begins; counted from the end when it runs backwards.':
    'Dónde del clip empieza; desde el final cuando va hacia atrás.',
  'Cross-fade': 'Fundido cruzado',
  'How long one clip fades into another.': 'Cuánto tarda en pasar de un clip a otro.',
  'A whole model, such as a glTF; an Animation plays its clips.':
    'Un modelo entero, como un glTF; una Animación reproduce sus clips.',
  'Morph targets': 'Destinos de deformación',
  'How much of the morph target is added.': 'Cuánto se añade del destino de deformación.',
  'Weights of the morph targets.': 'Los pesos de los destinos de deformación.',
  'Make editable copy': 'Hacer copia editable',
  'Copies the clip as one that can be edited, for the objects that the model is unpacked into':
    'Hace un clip propio a partir del clip del modelo, para los objetos en que se desempaqueta',
  'Clips of skeletons and morph targets play as they are: what they move stays one object when the model is unpacked.':
    'Los clips de esqueletos y de formas se reproducen como son: lo que mueven sigue siendo un solo objeto al desempaquetar el modelo.',
  '{name} can be edited as it is.': '{name} se puede editar tal como es.',
  'Left out, since no field holds it: {tracks}': 'Se omite, pues ningún campo lo contiene: {tracks}',
  'Clips that no Animation plays are left out': 'Se omiten los clips que ninguna Animación reproduce',
  'Tracks of clips without a target are left out': 'Se omiten las pistas de clips sin destino',
  'Events of clips are left out': 'Se omiten los eventos de los clips',
  'glTF animates places, turns, sizes and morph weights only: left out are tracks of {component}.{field}':
    'glTF solo anima posiciones, giros, tamaños y pesos de formas: se omiten pistas de {component}.{field}',
  'Curves and turns that glTF does not have are sampled at the frame rate':
    'Las curvas y los giros que glTF no tiene se muestrean a la velocidad de fotogramas',
};
