import type { Texts } from '@farol/editing';

/** All texts of the editor in Spanish, by their English ones. */
export const es: Texts = {};
