import { t } from '@farol/editing';
import { Camera } from '@farol/engine';
import type { Action } from '../api/Action';
import type { EditorApi } from '../api/EditorApi';

/** The selected camera, or else the scene's active one. */
function cameraOf({ document }: EditorApi): Camera | null {
  const selected = document.selectedObjects.at(-1)?.getComponent(Camera) ?? null;
  return selected ?? (document.scene.activeCamera as Camera | null);
}

const hasCamera = (editor: EditorApi): boolean => cameraOf(editor) !== null;

export const alignCameraToView: Action = {
  id: 'camera.alignToView',
  label: 'Align camera to view',
  keys: ['Ctrl+Shift+F'],
  icon: 'camera',
  async run(editor) {
    const camera = cameraOf(editor)!;
    const { lookThrough, viewed } = editor.viewport;
    if (camera === lookThrough) return;
    const { alignCamera } = await import('../model/cameraEdits');
    if (camera.isAttached) editor.commands.run(alignCamera(camera, viewed));
  },
  enabled: hasCamera,
};

export const alignViewToCamera: Action = {
  id: 'camera.alignView',
  label: 'Align view to camera',
  keys: ['Ctrl+Alt+F'],
  run: (editor) => editor.viewport.alignTo(cameraOf(editor)!),
  enabled: hasCamera,
};

export const createCameraFromView: Action = {
  id: 'camera.fromView',
  label: 'Create camera from view',
  icon: 'camera',
  async run({ commands, document, viewport }) {
    const { addCameraAt } = await import('../model/cameraEdits');
    commands.run(addCameraAt(document.scene, t('Camera'), viewport.viewed, document.selection.ids));
  },
};

/** Looks through a camera, or stops doing so. */
export const lookThroughCamera: Action = {
  id: 'camera.lookThrough',
  label: 'Look through the camera',
  keys: ['Numpad0'],
  icon: 'eye',
  run(editor) {
    const { viewport } = editor;
    viewport.lookThrough = viewport.lookThrough === null ? cameraOf(editor) : null;
  },
  checked: ({ viewport }) => viewport.lookThrough !== null,
  enabled: (editor) => editor.viewport.lookThrough !== null || hasCamera(editor),
};

export const cameraActions: readonly Action[] = [
  lookThroughCamera,
  alignCameraToView,
  alignViewToCamera,
  createCameraFromView,
];
