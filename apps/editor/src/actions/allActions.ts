import type { Action } from '../api/Action';
import type { EditorApi } from '../api/EditorApi';
import { techniqueActions, viewActions } from './pictureActions';
import { recentActions } from './recentActions';
import { showPanels } from './showPanels';

/** The actions of the registry, and those generated for each recent file, technique, view and panel. */
export const allActions = (editor: EditorApi): Action[] => [
  ...editor.actions.list,
  ...recentActions(editor),
  ...techniqueActions(editor),
  ...viewActions,
  ...showPanels(editor),
];
