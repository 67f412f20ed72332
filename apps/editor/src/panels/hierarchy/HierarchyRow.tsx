import type { GameObject } from '@farol/engine';
import type { ItemInstance, TreeInstance } from '@headless-tree/core';
import { memo, type MouseEvent, type ReactNode } from 'react';
import { setActive } from '../../model/edits';
import { useEditor } from '../../ui/EditorContext';
import { Icon } from '../../ui/Icon';
import { objectIcon } from './objectIcon';
import { INDENT } from './useObjectTree';

interface HierarchyRowProps {
  readonly tree: TreeInstance<string>;
  readonly item: ItemInstance<string>;
  readonly object: GameObject;
  /** From the top of the tree, and how high it is (CSS pixels). */
  readonly top: number;
  readonly height: number;
  /** See `rowState`: the row is rendered again when this differs. */
  readonly state: string;
  /** Called when the row is clicked. */
  onSelect(item: ItemInstance<string>, event: MouseEvent): void;
}

/** Everything that a row shows, as one text. */
export function rowState(tree: TreeInstance<string>, item: ItemInstance<string>, object: GameObject): string {
  const { level, setSize, posInSet } = item.getItemMeta();
  return [
    ...[object.name, objectIcon(object), object.active, object.activeInHierarchy, object.children.length > 0],
    ...[level, setSize, posInSet, item.isSelected(), item.isFocused(), item.isExpanded()],
    ...[item.isUnorderedDragTarget(), item.isRenaming() ? tree.getRenamingValue() : null],
  ].join('\n');
}

/** One GameObject: fold, icon, name, and whether it is shown. */
export const HierarchyRow = memo(function HierarchyRow(props: HierarchyRowProps): ReactNode {
  const { tree, item, object, top, height, onSelect } = props;
  const editor = useEditor();
  const hasChildren = object.children.length > 0;
  const states = [
    'row',
    item.isSelected() && 'selected',
    item.isUnorderedDragTarget() && 'drop-target',
    !object.activeInHierarchy && 'inactive',
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
          aria-label={`Name of ${object.name}`}
          onClick={(event) => event.stopPropagation()}
          onKeyDown={(event) => {
            event.stopPropagation();
            if (event.key === 'Enter') tree.completeRenaming();
            else if (event.key === 'Escape') tree.abortRenaming();
            else return;
            tree.updateDomFocus();
          }}
        />
      ) : (
        <span className="row-name">{object.name}</span>
      )}
      <button
        type="button"
        className="row-eye"
        tabIndex={-1}
        aria-label={object.active ? `Hide ${object.name}` : `Show ${object.name}`}
        title={object.active ? 'Hide (H)' : 'Show (H)'}
        aria-pressed={!object.active}
        onDoubleClick={(event) => event.stopPropagation()}
        onClick={(event) => {
          event.stopPropagation();
          editor.commands.run(setActive([object], !object.active));
        }}
      >
        <Icon name={object.active ? 'eye' : 'eyeOff'} size={14} />
      </button>
    </div>
  );
});
