import type { Texts } from '@farol/editing';

/** Spanish texts of light groups and of the panel Lights. */
export const lights: Texts = {
  'Light Group': 'Grupo de luces',
  'Light group': 'Grupo de luces',
  'Dims and tints all lights that name this object as their group; they are dark while it is off.':
    'Regula y tiñe todas las luces que tienen este objeto como grupo; están apagadas mientras lo está él.',
  Dimmer: 'Regulador',
  'Factor of the intensity of every light of the group; 0 is dark.':
    'Factor de la intensidad de cada luz del grupo; con 0 están apagadas.',
  'Multiplies the colour of every light of the group.': 'Multiplica el color de cada luz del grupo.',
  'Object with a Light Group, whose dimmer and colour multiply those of the light.':
    'Objeto con un Grupo de luces, cuyo regulador y color multiplican los de la luz.',
  'Object with a Light Group, whose dimmer multiplies the intensity.':
    'Objeto con un Grupo de luces, cuyo regulador multiplica la intensidad.',
  'No group': 'Sin grupo',
  'Made {group} of lights': 'Crear {group} con luces',
  'Put into a light group:': 'Poner en un grupo de luces:',
  'Took out of their light group:': 'Sacar de su grupo de luces:',
  '{count} K': '{count} K',
  'A click selects the object, a double click frames it.': 'Un clic selecciona el objeto; un doble clic lo encuadra.',
  'All groups': 'Todos los grupos',
  'All kinds': 'Todas las clases',
  'Colour of the light, sorted by hue, and its temperature where it has one.':
    'Color de la luz, ordenado por tono, y su temperatura si la tiene.',
  Cost: 'Coste',
  'Distance where the light ends.': 'Distancia donde la luz acaba.',
  'Drag to dim; press the number to type. Several selected rows are dimmed by one factor. A group has a percentage.':
    'Se arrastra para regular; el número se pulsa para escribirlo. Varias filas seleccionadas se regulan con un mismo factor. Un grupo tiene un porcentaje.',
  'End solo': 'Acabar el solo',
  'Group of lights': 'Grupo de las luces',
  'Kind of light': 'Clase de luz',
  'New group of selected lights': 'Nuevo grupo con las luces seleccionadas',
  'No light is in the scene yet.': 'Todavía no hay ninguna luz en la escena.',
  'Put into {name}': 'Poner en {name}',
  'Search lights': 'Buscar luces',
  Selected: 'Seleccionadas',
  'Share of the lighting time, estimated for this view: tiles of 32 pixels that the bounds of the light touch, as in the lists of lights, times the cost of its kind (rectangle 4, disc 6.4, tube 3.7, ambient 0), twice that with a shadow. Walls that hide it do not count.':
    'Parte del tiempo de iluminación, estimada para esta vista: teselas de 32 píxeles que tocan los límites de la luz, como en las listas de luces, por el coste de su clase (rectángulo 4, disco 6.4, tubo 3.7, ambiente 0), el doble con sombra. No cuentan las paredes que la tapan.',
  'Show only lights that are selected': 'Mostrar solo las luces seleccionadas',
  'Shows lights alone, until the scene plays or the panel is closed. Not saved.':
    'Muestra luces solas, hasta que la escena se reproduce o el panel se cierra. No se guarda.',
  Solo: 'Solo',
  'Solo of {name}': 'Solo de {name}',
  'Take out of group': 'Sacar del grupo',
  'Whether the light is switched on.': 'Si la luz está encendida.',
  '{column} of {name}': '{column} de {name}',
  '{count} light': '{count} luz',
  '{name} on': '{name}: encendida',
  '{shown} of {count}': '{shown} de {count}',
};
