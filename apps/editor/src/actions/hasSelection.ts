import type { EditorApi } from '../api/EditorApi';

export const hasSelection = ({ document }: EditorApi): boolean => document.selection.ids.length > 0;
