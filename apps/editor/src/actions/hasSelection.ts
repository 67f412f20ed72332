import type { Editor } from '../Editor';

/** Whether anything is selected. */
export const hasSelection = ({ document }: Editor): boolean => document.selection.ids.length > 0;
