import type { Texts } from '@farol/editing';

/** Spanish texts of baked light. */
export const bake: Texts = {
  'Baked light': 'Luz precalculada',
  'Baked light is left out: its lights shine themselves':
    'La luz precalculada se omite: sus luces alumbran por sí mismas',
  'Baked room': 'Habitación con luz precalculada',
  'Light that was baked, and a ball that moves through it. Play; then change a lamp, and bake again.':
    'Luz precalculada y una bola que se mueve por ella. Reproduce; después cambia una lámpara y vuelve a precalcular.',
  'No baked light': 'Sin luz precalculada',
  'Bake light…': 'Precalcular la luz…',
  Static: 'Estático',
  'The object stays where it is: baked light gives it a lightmap.':
    'El objeto no se mueve: la luz precalculada le da un mapa de luz.',
  'Made static:': 'Hacer estático:',
  'Made moving:': 'Hacer móvil:',
  'Make static': 'Hacer estático',
  'Make moving': 'Hacer móvil',
  '{count} objects below are different. Shall they change too?':
    'Debajo hay {count} objetos que están de otro modo. ¿Cambiarlos también?',
  'Change all': 'Cambiar todos',
  'Only the selected': 'Solo los seleccionados',
  'Made baked:': 'Precalcular:',
  'Baked the light': 'Precalcular la luz',
  'Cleared the baked light': 'Quitar la luz precalculada',
  'The scene is playing: stop it to bake its light.':
    'La escena está en marcha: hay que detenerla para precalcular su luz.',
  'Nothing is static: switch on Static for objects that do not move.':
    'Nada es estático: hay que activar Estático en lo que no se mueve.',
  'No light is baked: set the mode of lights to Baked.':
    'Ninguna luz se precalcula: hay que poner luces en modo Precalculada.',
  'The scene was edited: the bake was stopped.': 'La escena se editó: el cálculo de la luz se detuvo.',
  Lightmaps: 'Mapas de luz',
  'How finely light is baked on surfaces.': 'Con qué detalle se calcula la luz sobre las superficies.',
  'Light probes': 'Sondas de luz',
  'They give baked light to objects that are not static.':
    'Por ellas llega la luz precalculada a lo que no es estático.',
  '{count} static object': '{count} objeto estático',
  '{count} static objects': '{count} objetos estáticos',
  '{count} baked light': '{count} luz precalculada',
  '{count} baked lights': '{count} luces precalculadas',
  'Make {count} object static': 'Hacer estático {count} objeto',
  'Make {count} objects static': 'Hacer estáticos {count} objetos',
  'Set {count} light to Baked': 'Poner {count} luz en Precalculada',
  'Set {count} lights to Baked': 'Poner {count} luces en Precalculada',
  '{count} instanced objects have no lightmap: probes light them.':
    'Los objetos instanciados no tienen mapa de luz: los iluminan las sondas. Son {count}.',
  Bake: 'Precalcular',
  'Unfolding surfaces': 'Desplegando superficies',
  Preparing: 'Preparando',
  'Tracing light': 'Trazando la luz',
  Finishing: 'Terminando',
  Packing: 'Empaquetando',
  '{seconds} s left': 'quedan {seconds} s',
  '{minutes} min {seconds} s left': 'quedan {minutes} min {seconds} s',
  Baking: 'Precalculando',
  '{count} samples': '{count} muestras',
  '{kilobytes} kB': '{kilobytes} kB',
  '{megabytes} MB': '{megabytes} MB',
  '{count} mesh': '{count} malla',
  '{count} meshes': '{count} mallas',
  '{count} light probe': '{count} sonda de luz',
  '{count} light probes': '{count} sondas de luz',
  'Out of date: something that was baked has changed. Bake again.':
    'Desactualizada: algo de lo precalculado ha cambiado. Hay que volver a precalcular.',
  Mode: 'Modo',
  'Baked light is in lightmaps and probes and costs nothing; of a mixed light only what surfaces reflect is baked.':
    'La luz precalculada está en mapas y sondas y no cuesta nada; de una luz mixta solo se precalcula lo que reflejan las superficies.',
  Realtime: 'En tiempo real',
  Mixed: 'Mixta',
  Baked: 'Precalculada',
  'Source radius': 'Radio de la fuente',
  'Radius of what shines: the larger, the softer are its baked shadows.':
    'Radio de lo que brilla: cuanto mayor, más suaves son sus sombras precalculadas.',
  'Source angle': 'Ángulo de la fuente',
  'Angle that the source covers, 0.5° for the sun: the larger, the softer are its baked shadows.':
    'Ángulo que cubre la fuente, 0.5° para el sol: cuanto mayor, más suaves son sus sombras precalculadas.',
  'Lightmaps and probes that light the scene.': 'Mapas y sondas de luz que iluminan la escena.',
  'Lightmap size': 'Tamaño del mapa de luz',
  'Width and height of a lightmap, in texels.': 'Ancho y alto de un mapa de luz, en téxeles.',
  'Texels along a metre of surface, in as many lightmaps as that takes; 0 for as many as one lightmap has room for.':
    'Téxeles por metro de superficie, en los mapas que hagan falta; 0 para los que quepan en un solo mapa.',
  'texels/m': 'téxeles/m',
  Bounces: 'Rebotes',
  'How often light is reflected before it arrives; 0 for direct light alone.':
    'Cuántas veces se refleja la luz antes de llegar; 0 para solo luz directa.',
  'Paths of light to each texel: more take longer and leave less noise.':
    'Caminos de luz a cada téxel: más tardan más y dejan menos ruido.',
  'Sky and environment light what is baked.': 'El cielo y el entorno iluminan lo que se precalcula.',
  Denoise: 'Quitar ruido',
  'Takes out the noise that is left.': 'Quita el ruido que queda.',
  'Stitch seams': 'Coser costuras',
  'Makes light agree on both sides where a smooth surface is cut for its lightmap; else the cuts may show as lines.':
    'La luz coincide donde una superficie lisa se corta para su mapa de luz; si no, los cortes pueden verse como líneas.',
  'Light probes, by which baked light reaches objects that are not static.':
    'Sondas de luz, por las que la luz precalculada llega a los objetos que no son estáticos.',
  'Probe spacing': 'Separación de las sondas',
  'Distance between light probes, at least; farther where there would be too many.':
    'Distancia mínima entre sondas de luz; mayor donde serían demasiadas.',
};
