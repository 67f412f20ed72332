import { t } from '@farol/editing';
import { Component } from '@farol/engine';
import { type FieldOwner, type FieldValue, isTriple } from '@farol/engine/fields';
import { fieldOverride } from '@farol/engine/prefabs';
import type { ReactNode } from 'react';
import { applyField, revertField } from '../../model/prefabEdits';
import { useEditor, useSignal } from '../../ui/EditorContext';
import { keysText } from '../../ui/keysText';
import { MenuButton } from '../../ui/MenuButton';
import './prefab.css';

function textOf(value: FieldValue): string {
  if (isTriple(value)) return value.map((each) => Number(each.toFixed(3))).join(', ');
  return Array.isArray(value) ? keysText(value) : String(value ?? t('none'));
}

interface OverrideMarkProps {
  readonly owners: readonly FieldOwner[];
  readonly name: string;
  readonly label: string;
}

/** Marks a field of an instance that differs from its prefab, with buttons to revert the value or to apply it. */
export function OverrideMark({ owners, name, label }: OverrideMarkProps): ReactNode {
  const editor = useEditor();
  const { document, commands } = editor;
  useSignal(document.prefabs);
  const [owner] = owners;
  if (owners.length !== 1 || !(owner instanceof Component) || !owner.scene) return null;
  const override = fieldOverride(owner, name);
  if (!override) return null;
  const { scene, selection } = document;
  return (
    <span className="override-mark">
      <MenuButton
        label={t('{label} differs from the prefab', { label })}
        icon="prefab"
        iconOnly
        className="button small"
        entries={() => [
          {
            label: t('Revert to prefab'),
            help: t('The prefab has {value}.', { value: textOf(override.base) }),
            icon: 'undo',
            run: () => editor.attempt(() => commands.run(revertField(scene, override, selection.ids))),
          },
          {
            label: t('Apply to prefab'),
            help: t('Every instance without a value of its own follows.'),
            icon: 'check',
            run: () => editor.attempt(() => commands.run(applyField(scene, owner, name, selection.ids))),
          },
        ]}
      />
    </span>
  );
}
