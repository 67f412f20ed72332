import type { Texts } from '@farol/editing';

/** Scripts. */
export const scripts: Texts = {
  'Text of the script': 'Texto del script',
  'Search scripts': 'Buscar scripts',
  'New script': 'Nuevo script',
  'What can be done with the script': 'Qué se puede hacer con el script',
  '{name}, broken': '{name}, con errores',
  'Cannot be read yet: the last good text runs': 'Aún no se puede leer: funciona el último texto correcto',
  'A script is a component of your own: a class with fields and what it does each frame.':
    'Un script es un componente propio: una clase con campos y lo que hace en cada fotograma.',
  'No completion: {reason}': 'Sin autocompletado: {reason}',
  'Completion is being fetched…': 'Cargando el autocompletado…',
  '{count} error of types': '{count} error de tipos',
  '{count} errors of types': '{count} errores de tipos',
  'Made script {name}': 'Script {name} creado',
  'Edited script {name}': 'Script {name} editado',
  'is no script.': 'no es un script.',
  script: 'script',
};
