import type { Action } from '../api/Action';
import type { EditorApi } from '../api/EditorApi';
import type { Shading } from '../viewport/shading/Shading';

/** Sets the active view's shading, and remembers it. */
export function setShading({ viewport, preferences }: EditorApi, shading: Shading): void {
  const { active } = viewport.panes;
  viewport.shade(active, shading);
  preferences.setState(({ views }) => ({
    views: { ...views, shadings: { ...views.shadings, [active.name]: shading } },
  }));
}

const shading = (name: Shading & string, label: string): Action => ({
  id: `view.shading.${name}`,
  label,
  menu: { menu: 'view', group: 'shading', submenu: 'Shading' },
  run: (editor) => setShading(editor, name),
  checked: ({ viewport }) => viewport.shading === name,
  enabled: ({ viewport }) => viewport.painter === null,
});

/** One action for each shading of the active view. */
export const shadings: readonly Action[] = [
  shading('scene', "As the scene's technique lights it"),
  shading('unlit', 'Unlit colours'),
  shading('clay', 'Clay'),
  shading('wireframe', 'Wireframe'),
];

/** Opens the viewport's menu of shadings. */
export const showShadings: Action = {
  id: 'view.shadingMenu',
  label: 'Choose the shading…',
  keys: ['Z'],
  menu: { menu: 'view', group: 'shading', submenu: 'Shading' },
  run: ({ viewport }) => viewport.shadingAsked.emit(),
  enabled: ({ viewport }) => viewport.painter === null,
};
