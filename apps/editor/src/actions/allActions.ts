import type { Action } from '../api/Action';
import type { EditorApi } from '../api/EditorApi';
import { techniqueActions, viewActions } from './pictureActions';
import { showPanels } from './showPanels';

/** The actions of the registry, and those for each panel, technique and view that there is. */
export const allActions = (editor: EditorApi): Action[] => [
  ...editor.actions.list,
  ...techniqueActions(editor),
  ...viewActions,
  ...showPanels(editor),
];
