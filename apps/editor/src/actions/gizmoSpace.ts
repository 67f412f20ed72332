import { t } from '@farol/editing';
import type { Action } from '../api/Action';

export const gizmoSpace: Action = {
  id: 'gizmo.space',
  label: ({ viewport }) =>
    viewport.space === 'local' ? t("Handles along the object's axes") : t("Handles along the world's axes"),
  keys: ['X'],
  icon: 'local',
  run({ viewport }) {
    viewport.space = viewport.space === 'local' ? 'world' : 'local';
  },
  checked: ({ viewport }) => viewport.space === 'local',
};
