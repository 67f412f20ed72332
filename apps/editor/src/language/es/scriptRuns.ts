import type { Texts } from '@farol/editing';

/** Spanish texts about running scripts. */
export const scriptRuns: Texts = {
  '{component} of {owner} is off until the scene stops, since it threw: {message} ({script}, line {line})':
    '{component} de {owner} queda desactivado hasta que la escena se detenga, porque falló: {message} ({script}, línea {line})',
  'Scripts are off': 'Los scripts están desactivados',
  'The scripts of this scene are off, since it comes from elsewhere. Run them only if you trust it.':
    'Los scripts de esta escena están desactivados, porque viene de otro sitio. Conviene ejecutarlos solo si se confía en ella.',
  'Scripts are off: the page ended while they ran. Correct the one that does not end, then run them.':
    'Los scripts están desactivados: la página se cerró mientras se ejecutaban. Hay que corregir el que no termina y después ejecutarlos.',
  'Scripts are off, by ?scripts=off in the address.':
    'Los scripts están desactivados, como dice la dirección de la página.',
  'Scripts stay off while another page shows the editor inside of it. Open the editor by itself to run them.':
    'Los scripts siguen desactivados mientras otra página muestra el editor dentro de ella. Para ejecutarlos hay que abrir el editor solo.',
  'Look at them': 'Verlos',
  'Keep them off': 'Dejarlos desactivados',
};
