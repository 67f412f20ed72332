import { isComposing, t } from '@farol/editing';
import type { GameObject } from '@farol/engine';
import type { ItemInstance, TreeInstance } from '@headless-tree/core';
import { memo, type MouseEvent, type ReactNode } from 'react';
import { setActive, setLocked } from '../../model/edits';
import { useEditor } from '../../ui/EditorContext';
import { Icon } from '../../ui/Icon';
import { objectIcon } from './objectIcon';
import { RowSwitch } from './RowSwitch';
import { INDENT } from './useObjectTree';

interface HierarchyRowProps {
  readonly tree: TreeInstance<string>;
  readonly item: ItemInstance<string>;
  readonly object: GameObject;
  /** Distance of the row from the top of the tree; `height` is the row's height (CSS pixels). */
  readonly top: number;
  readonly height: number;
  /** Text of `rowState`; the row is rendered again when it changes. */
  readonly state: string;
  /** Called when the row is clicked. */
  onSelect(item: ItemInstance<string>, event: MouseEvent): void;
}

/** Everything that a row shows, as one text to compare. */
export function rowState(tree: TreeInstance<string>, item: ItemInstance<string>, object: GameObject): string {
  const { level, setSize, posInSet } = item.getItemMeta();
  return [
    ...[
      object.name,
      objectIcon(object),
      object.active,
      object.activeInHierarchy,
      object.locked,
      object.lockedInHierarchy,
      object.children.length > 0,
    ],
    ...[level, setSize, posInSet, item.isSelected(), item.isFocused(), item.isExpanded()],
    object.prefabLink !== null,
    ...[item.isUnorderedDragTarget(), item.isRenaming(), item.isRenaming() && tree.getRenamingValue()],
  ].join('\n');
}

/** Row of one GameObject: fold, icon, name, and switches. */
export const HierarchyRow = memo(function HierarchyRow(props: HierarchyRowProps): ReactNode {
  const { tree, item, object, top, height, onSelect } = props;
  const editor = useEditor();
  const hasChildren = object.children.length > 0;
  const states = [
    'row',
    item.isSelected() && 'selected',
    item.isUnorderedDragTarget() && 'drop-target',
    !object.activeInHierarchy && 'inactive',
    object.prefabLink && 'instance',
  ];
  return (
    <div
      {...item.getProps()}
      className={states.filter(Boolean).join(' ')}
      style={{ height, transform: `translateY(${top}px)`, paddingInlineStart: 6 + item.getItemMeta().level * INDENT }}
      aria-expanded={hasChildren ? item.isExpanded() : undefined}
      data-object-id={object.id}
      onClick={(event) => onSelect(item, event)}
      onDoubleClick={() => editor.viewport.focus()}
    >
      <button
        type="button"
        className="fold"
        tabIndex={-1}
        aria-hidden="true"
        data-open={item.isExpanded()}
        style={hasChildren ? undefined : { visibility: 'hidden' }}
        onDoubleClick={(event) => event.stopPropagation()}
        onClick={(event) => {
          event.stopPropagation();
          if (item.isExpanded()) item.collapse();
          else item.expand();
        }}
      >
        <Icon name="chevron" size={10} />
      </button>
      <Icon name={objectIcon(object)} size={14} />
      {item.isRenaming() ? (
        <input
          {...item.getRenameInputProps()}
          className="input rename"
          aria-label={t('Name of {name}', { name: object.name })}
          onClick={(event) => event.stopPropagation()}
          onFocus={({ currentTarget }) => currentTarget.select()}
          // not by `abortRenaming`, which would move the focus back into the tree
          onBlur={() => tree.applySubStateUpdate('renamingItem', null)}
          onKeyDown={(event) => {
            event.stopPropagation();
            if (isComposing(event)) return;
            if (event.key === 'Enter') tree.completeRenaming();
            else if (event.key === 'Escape') tree.abortRenaming();
          }}
        />
      ) : (
        <span className="row-name one-line">{object.name}</span>
      )}
      <RowSwitch
        name={object.name}
        isOn={object.locked}
        isInherited={object.lockedInHierarchy}
        words={[t('Lock'), t('Unlock'), 'L']}
        icons={['lockOpen', 'lock']}
        onChange={(locked) => editor.commands.run(setLocked([object], locked))}
      />
      <RowSwitch
        name={object.name}
        isOn={!object.active}
        isInherited={!object.activeInHierarchy}
        words={[t('Hide'), t('Show'), 'H']}
        icons={['eye', 'eyeOff']}
        onChange={(hidden) => editor.commands.run(setActive([object], !hidden))}
      />
    </div>
  );
});
