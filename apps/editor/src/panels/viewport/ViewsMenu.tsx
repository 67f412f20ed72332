import { t } from '@farol/editing';
import type { ReactNode } from 'react';
import { keepView, nameOfView, places, showViews } from '../../actions/bookmarks';
import { cameraActions } from '../../actions/cameras';
import { lookFrom, toggleOrthographic } from '../../actions/viewpoint';
import { nextView, resetViews } from '../../actions/display';
import type { EditorApi } from '../../api/EditorApi';
import { actionEntry, type MenuEntry } from '../../api/MenuEntry';
import { setView } from '../../model/commands/SetValue';
import { useEditor } from '../../ui/EditorContext';
import { MenuButton } from '../../ui/MenuButton';

function forgetView({ commands, document }: EditorApi, place: number): void {
  const view = document.scene.views.get(place);
  if (!view) return;
  const label = t('Forget {name}', { name: nameOfView(place, view) });
  commands.run(setView(label, document.scene, place, null));
}

/** Asks for a name of a stored view. */
function renameView({ commands, dialogs, document }: EditorApi, place: number): void {
  const { scene } = document;
  const view = scene.views.get(place);
  if (!view) return;
  void dialogs.show({
    kind: 'text',
    title: t('Name of the view'),
    label: t('Name'),
    value: nameOfView(place, view),
    action: t('Rename'),
    accept: (name) => commands.run(setView(t('Rename {name}', { name }), scene, place, { ...view, name })),
  });
}

/** The first number without a stored view; 9 when all are taken. */
const freePlace = ({ document }: EditorApi): number =>
  places.find((place) => document.scene.views.get(place) === null) ?? places.length;

function entriesOf(editor: EditorApi): readonly MenuEntry[] {
  const { document, viewport } = editor;
  const kept = document.scene.views.entries;
  const each = (run: (editor: EditorApi, place: number) => void): MenuEntry[] =>
    kept.map(([place, view]) => ({
      label: nameOfView(place, view),
      run: () => editor.attempt(() => run(editor, place)),
    }));
  const shown = showViews.filter((action) => action.enabled?.(editor)).map((action) => actionEntry(action, editor));
  const keep: MenuEntry = {
    label: t('Keep this view'),
    icon: 'add',
    run: () => editor.attempt(() => keepView(editor, freePlace(editor))),
  };
  const change: MenuEntry[] = [
    { label: t('Rename a view'), entries: each(renameView) },
    { label: t('Forget a view'), entries: each(forgetView) },
  ];
  return [
    ...shown,
    keep,
    ...(kept.length > 0 ? change : []),
    'separator',
    { label: t('Look from'), entries: lookFrom.map((action) => actionEntry(action, editor)) },
    actionEntry(toggleOrthographic, editor),
    ...(viewport.isQuad ? [nextView, resetViews].map((action) => actionEntry(action, editor)) : []),
    'separator',
    ...cameraActions.map((action) => actionEntry(action, editor)),
  ];
}

/** Menu of viewpoints: stored views, sides, and cameras of the scene. */
export function ViewsMenu(): ReactNode {
  const editor = useEditor();
  return <MenuButton label={t('Views and cameras')} icon="camera" iconOnly entries={() => entriesOf(editor)} />;
}
