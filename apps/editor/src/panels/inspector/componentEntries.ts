import { namesOf, t } from '@farol/editing';
import type { Component } from '@farol/engine';
import type { EditorApi } from '../../api/EditorApi';
import { copyComponent, fittingValues, readComponentClip } from '../../model/componentClip';
import { addComponent, moveComponents, removeComponents, resetFields, setValues } from '../../model/edits';
import type { MenuEntry } from '../../api/MenuEntry';
import { wordsOf } from './componentIcons';

/** Menu of a component of the selected objects. @param components - one of each object */
export function componentEntries(editor: EditorApi, components: readonly Component[]): MenuEntry[] {
  const { commands, document, clipboard } = editor;
  const [first] = components;
  const { typeName } = first;
  const title = wordsOf(typeName);
  const isTransform = typeName === 'Transform';
  const words = { component: title, name: namesOf(components.map(({ gameObject }) => gameObject)) };
  const list = first.gameObject.components;
  const place = list.indexOf(first);
  const clip = readComponentClip(clipboard.text);
  const clipType = clip && document.scene.registry.types.get(clip.type);
  const values = clip?.type === typeName ? fittingValues(clip, first.fields) : null;
  const objects = components.map(({ gameObject }) => gameObject);
  const canAdd =
    clipType &&
    clip.type !== 'Transform' &&
    !(clipType.unique && objects.every((each) => each.getComponent(clip.type)));
  const attempt = (run: () => void) => () => editor.attempt(run);
  return [
    {
      label: t('Copy values'),
      icon: 'copy',
      run: attempt(() => {
        clipboard.text = copyComponent(first);
      }),
    },
    {
      label: t('Paste values'),
      icon: 'paste',
      disabled: !values,
      run: attempt(
        () =>
          values && commands.run(setValues(t('Pasted values into {component} of {name}', words), components, values)),
      ),
    },
    {
      label: clipType ? t('Paste as new {title}', { title: wordsOf(clipType.typeName) }) : t('Paste as new'),
      disabled: !canAdd,
      run: attempt(() => {
        if (!clip || !clipType) return;
        commands.run(addComponent(document.scene, objects, clipType, fittingValues(clip, clipType.fields)));
      }),
    },
    'separator',
    {
      label: t('Move up'),
      icon: 'up',
      disabled: place < 2,
      run: attempt(() => commands.run(moveComponents(components, -1))),
    },
    {
      label: t('Move down'),
      icon: 'down',
      disabled: isTransform || place === list.length - 1,
      run: attempt(() => commands.run(moveComponents(components, 1))),
    },
    'separator',
    {
      label: t('Reset'),
      help: t('Gives every field its default.'),
      icon: 'undo',
      run: attempt(() => commands.run(resetFields(t('Reset {component} of {name}', words), components))),
    },
    {
      label: t('Remove'),
      icon: 'remove',
      disabled: isTransform,
      run: attempt(() => commands.run(removeComponents(document.scene, components))),
    },
  ];
}
