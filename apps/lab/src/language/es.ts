import type { Texts } from '@farol/editing';
import { es as editing, esOfApps } from '@farol/editing/es';
import { page } from './es/page';
import { results } from './es/results';

/** All texts of the Lab in Spanish, by their English ones. */
export const es: Texts = { ...editing, ...esOfApps, ...results, ...page };
