import type { Action } from '../api/Action';
import type { EditorApi } from '../api/EditorApi';
import { hasSelection } from './hasSelection';

const areStatic = ({ document }: EditorApi): boolean => document.selectedObjects.every(({ isStatic }) => isStatic);

/** Marks the selected objects as static, or as moving. */
export const toggleStatic: Action = {
  id: 'edit.static',
  label: 'Static',
  icon: 'lamp',
  menu: { menu: 'object', group: 'state' },
  async run(editor) {
    const { selectedObjects } = editor.document;
    const isStatic = !areStatic(editor);
    const { changeStatic } = await import('./changeStatic');
    void changeStatic(editor, selectedObjects, isStatic); // the dialog that it may open outlasts the action
  },
  enabled: hasSelection,
  checked: (editor) => editor.document.selectedObjects.length > 0 && areStatic(editor),
};

export const bakeLight: Action = {
  id: 'object.bake-light',
  label: 'Bake light…',
  icon: 'lamp',
  menu: { menu: 'object', group: 'light' },
  run: ({ layout }) => layout.open('bake'),
};
