import type { Texts } from '@farol/editing';

/** Spanish texts of the player, which shows exported and linked scenes. */
export const player: Texts = {
  'Files of other hosts': 'Archivos de otros servidores',
  '… and {count} more': '… y {count} más',
  'This scene asks for files of other hosts, which would learn that you open it:':
    'Esta escena pide archivos de otros servidores, que sabrían que se abre:',
  'Scripts of the scene': 'Scripts de la escena',
  'This scene has scripts, which are programs of whoever made the link. They reach none of your files and no other host, but may keep this device busy.':
    'Esta escena tiene scripts, que son programas de quien hizo el enlace. No llegan a ningún archivo de quien la abre ni a otros servidores, pero pueden tener ocupado el dispositivo.',
  'This page shows a scene with JavaScript and WebGL 2: switch JavaScript on, or, where it is in a frame that allows no scripts, open it by itself.':
    'Esta página muestra una escena con JavaScript y WebGL 2: hay que activar JavaScript o, si está en un marco que no permite scripts, abrirla sola.',
  'The editor is not connected; edits follow once it is.': 'El editor no está; sus cambios llegarán cuando vuelva.',
  'The connection was lost; trying again…': 'Se perdió la conexión, y se intenta de nuevo.',
  'Waiting for the editor…': 'Esperando al editor…',
  Jump: 'Saltar',
  'Run them': 'Ejecutarlos',
  'Click for sound': 'Un clic para oír el sonido',
  'Load from these hosts': 'Cargar de estos servidores',
  'Open without them': 'Abrir sin ellos',
  'The link is damaged or cut short: copy all of it, to its last letter.':
    'El enlace está dañado o cortado: hay que copiarlo entero, hasta la última letra.',
  'The address has no scene in it: it must end with #scene=…':
    'La dirección no contiene ninguna escena: tiene que seguir con #scene=…',
  'The page has no physics: export the scene again.': 'La página no tiene física: hay que exportar de nuevo la escena.',
  'The physics could not be loaded: reload the page.': 'No se pudo obtener la física.',
};
