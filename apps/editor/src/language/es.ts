import type { Texts } from '@farol/editing';
import { actions } from './es/actions';
import { components } from './es/components';
import { edits } from './es/edits';
import { messages } from './es/messages';
import { panels } from './es/panels';
import { rendering } from './es/rendering';

/** All texts of the editor in Spanish, by their English ones. */
export const es: Texts = { ...actions, ...components, ...edits, ...messages, ...panels, ...rendering };
