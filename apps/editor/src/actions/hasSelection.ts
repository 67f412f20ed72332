import type { EditorApi } from '../api/EditorApi';

/** Whether an object is selected. */
export const hasSelection = ({ document }: EditorApi): boolean => document.selection.ids.length > 0;
