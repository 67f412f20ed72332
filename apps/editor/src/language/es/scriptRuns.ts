import type { Texts } from '@farol/editing';

/** Scripts that run. */
export const scriptRuns: Texts = {
  '{component} of {owner} is off until the scene stops, since it threw: {message} ({script}, line {line})':
    '{component} de {owner} queda desactivado hasta que la escena se detenga, porque falló: {message} ({script}, línea {line})',
};
