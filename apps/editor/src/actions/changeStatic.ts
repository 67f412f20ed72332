import { t } from '@farol/editing';
import type { GameObject } from '@farol/engine';
import type { EditorApi } from '../api/EditorApi';
import { setStatic } from '../model/edits';

/** Makes objects static or moving. When some of their descendants differ, asks whether these change too. */
export async function changeStatic(
  { commands, dialogs }: EditorApi,
  objects: readonly GameObject[],
  isStatic: boolean,
): Promise<void> {
  const all = new Set<GameObject>();
  for (const object of objects) object.traverse((each) => all.add(each));
  const below = [...all].filter((each) => !objects.includes(each) && each.isStatic !== isStatic);
  let changed: readonly GameObject[] | null = objects;
  if (below.length > 0) {
    changed = null;
    const agreed = await dialogs.show({
      kind: 'confirm',
      title: isStatic ? t('Make static') : t('Make moving'),
      text: t('{count} objects below are different. Shall they change too?', { count: below.length }),
      action: t('Change all'),
      other: { label: t('Only the selected'), choose: () => (changed = objects) },
    });
    if (agreed) changed = [...objects, ...below];
  }
  if (changed) commands.run(setStatic(changed, isStatic));
}
