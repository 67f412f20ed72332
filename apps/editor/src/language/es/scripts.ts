import type { Texts } from '@farol/editing';

/** Spanish texts of script editing. */
export const scripts: Texts = {
  'Text of the script': 'Texto del script',
  'Search scripts': 'Buscar scripts',
  'New script': 'Nuevo script',
  'Menu of the script': 'Menú del script',
  '{name}, broken': '{name}, con errores',
  'Syntax error: the last valid text runs': 'Aún no se puede leer: funciona el último texto correcto',
  'A script is a component of your own: a class with fields and what it does each frame.':
    'Un script es un componente propio: una clase con campos y lo que hace en cada fotograma.',
  'No completion: {reason}': 'Sin autocompletado: {reason}',
  'Completion is loading…': 'Cargando el autocompletado…',
  '{count} error': '{count} error',
  '{count} errors': '{count} errores',
  '{component} of {object} threw: {reason}': '{component} de {object} lanzó: {reason}',
  'Made script {name}': 'Script {name} creado',
  'Made script {name} for {objects}': 'Script {name} creado para {objects}',
  'has no component: export its class by default.': 'no tiene componente: debe exportar su clase por defecto.',
  '{field} is kept as data, and does nothing.': '{field} se conserva como datos y no hace nada.',
  'Add to the selected objects': 'Añadir a los objetos seleccionados',
  '{count} line': '{count} línea',
  '{count} lines': '{count} líneas',
  'Drop {name} on an object, which then gets it as a component.':
    'Hay que soltar {name} sobre un objeto, que lo recibe como componente.',
  'New script…': 'Nuevo script…',
  'A component of your own, written here.': 'Un componente propio, escrito aquí.',
  'Edit script {name}': 'Editar el script {name}',
  'Edited script {name}': 'Script {name} editado',
  'is not a script.': 'no es un script.',
  'Edit ## the text of a script': 'Editar',
  script: 'script',
};
