import type { Texts } from '@farol/editing';
import { page } from './es/page';
import { results } from './es/results';
import { shared } from './es/shared';

/** All texts of the Lab in Spanish, by their English ones. */
export const es: Texts = { ...shared, ...results, ...page };
