import { t, tCount } from '@farol/editing';
import type { GameObject } from '@farol/engine';
import { instanceRootOf, overridesOf } from '@farol/engine/prefabs';
import type { ReactNode } from 'react';
import { applyInstance, revertInstance, unpackInstance } from '../../model/prefabEdits';
import { splitName } from '../../model/assetNames';
import { useEditor, useSignal } from '../../ui/EditorContext';
import { Icon } from '../../ui/Icon';
import { MenuButton } from '../../ui/MenuButton';
import './prefab.css';

/** Prefab of the selected instance, its overrides, and buttons to revert, apply or unpack. */
export function PrefabBar({ object }: { object: GameObject }): ReactNode {
  const editor = useEditor();
  const { document, commands } = editor;
  useSignal(document.prefabs);
  useSignal(document.edited);
  const { scene, selection } = document;
  const root = instanceRootOf(object);
  const prefab = root?.prefabLink ? scene.prefabs.get(root.prefabLink.prefab) : null;
  if (!root || !prefab) return null;
  const { fields, structural } = overridesOf(root);
  const list = [...fields.map(({ path }) => path), ...structural];
  const run = (make: typeof applyInstance) => (): void =>
    editor.attempt(() => commands.run(make(scene, root, selection.ids)));
  const none = list.length === 0;
  return (
    <div className="prefab-bar" role="group" aria-label={t('Prefab')}>
      <Icon name="prefab" />
      <span className="prefab-name one-line" title={list.join('\n')}>
        {splitName(prefab.name).leaf}
        <span className="prefab-count">
          {none ? t('as the prefab') : tCount(list.length, '{count} override', '{count} overrides')}
        </span>
      </span>
      <MenuButton
        label={t('Prefab')}
        entries={() => [
          {
            label: t('Apply all to prefab'),
            help: none ? t('It has no overrides.') : list.slice(0, 6).join(', '),
            icon: 'check',
            disabled: none,
            run: run(applyInstance),
          },
          {
            label: t('Revert all'),
            help: t('Makes this instance equal to the prefab.'),
            icon: 'undo',
            disabled: none,
            run: run(revertInstance),
          },
          'separator',
          ...(root === object
            ? []
            : [
                { label: t('Select the whole instance'), icon: 'select' as const, run: () => selection.set([root.id]) },
              ]),
          {
            label: t('Unpack'),
            help: t('Turns it into plain objects without a prefab.'),
            icon: 'object',
            run: run(unpackInstance),
          },
        ]}
      />
    </div>
  );
}
