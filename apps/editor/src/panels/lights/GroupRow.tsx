import { FieldGesture, t, tCount } from '@farol/editing';
import type { ReactNode } from 'react';
import { setEnabled } from '../../model/edits';
import type { LightRow } from '../../model/lights/LightTable';
import { ownersName } from '../../model/ownersName';
import { Icon } from '../../ui/Icon';
import type { RowProps } from './LightRowView';
import { NumberCell } from './NumberCell';
import { useRowEdit } from './useRowEdit';
import { CheckCell, ColourCell, CostCell, SoloCell } from './cells';

const Fold = ({ table, id, name }: Pick<RowProps, 'table'> & { id: string; name: string }): ReactNode => (
  <button
    type="button"
    className="fold"
    tabIndex={-1}
    aria-label={table.isFolded(id) ? t('Unfold {name}', { name }) : t('Fold {name}', { name })}
    data-open={!table.isFolded(id)}
    onDoubleClick={(event) => event.stopPropagation()}
    onClick={(event) => {
      event.stopPropagation();
      table.fold(id, !table.isFolded(id));
    }}
  >
    <Icon name="chevron" size={10} />
  </button>
);

const Count = ({ count }: { readonly count: number }): ReactNode => (
  <span role="gridcell" className="dim">
    {tCount(count, '{count} light', '{count} lights')}
  </span>
);

/** Cells of a group: its switch, solo of its lights, name, colour filter and dimmer. */
export function GroupCells({ row, ...desk }: RowProps & { readonly row: LightRow & { kind: 'group' } }): ReactNode {
  const { editor, table, tabIndex } = desk;
  const { group, object } = row;
  const { name } = object;
  const edit = useRowEdit(editor, () => {
    const groups = table.editedBy(group);
    return new FieldGesture(editor.commands, groups, 'dimmer', () => ownersName(groups));
  });
  const members = table.membersOf(row.id);
  const preview = (next: number): void => edit.onPreview(next / 100);
  const percent = Number(((group.getAuthored('dimmer') as number) * 100).toFixed(2));
  return (
    <>
      <CheckCell
        label={t('{name} on', { name })}
        isOn={group.enabled}
        tabIndex={tabIndex}
        onChange={(isOn) => editor.commands.run(setEnabled(table.editedBy(group), isOn))}
      />
      <SoloCell
        name={name}
        isOn={table.areSolo(members)}
        tabIndex={tabIndex}
        onChange={(isOn) => table.setSolo(members, isOn)}
      />
      <span role="gridcell" className="lights-name">
        <Fold table={table} id={row.id} name={name} />
        <Icon name="sliders" size={14} />
        <span className="row-name one-line">{name}</span>
      </span>
      <Count count={row.count} />
      <ColourCell
        label={t('{column} of {name}', { column: t('Colour'), name })}
        colour={group.colour}
        tabIndex={tabIndex}
        onPick={(anchor) => desk.onPick({ anchor, edited: group })}
      />
      <span role="gridcell">
        <NumberCell
          value={percent}
          unit="%"
          min={0}
          max={1000}
          step={1}
          label={t('{column} of {name}', { column: t('Dimmer'), name })}
          dimmer={100}
          tabIndex={tabIndex}
          onDim={preview}
          onPreview={preview}
          onCommit={edit.onCommit}
          onDiscard={edit.onDiscard}
        />
      </span>
      <span role="gridcell" />
      <span role="gridcell" />
      <CostCell cost={table.costOf(row)} />
    </>
  );
}

/** Cells of the heading above lights without a group. */
export const RestCells = ({ row, table }: RowProps & { readonly row: LightRow & { kind: 'rest' } }): ReactNode => (
  <>
    <span role="gridcell" />
    <span role="gridcell" />
    <span role="gridcell" className="lights-name dim">
      <Fold table={table} id="" name={t('No group')} />
      {t('No group')}
    </span>
    <Count count={row.count} />
    {[4, 5, 6, 7].map((column) => (
      <span key={column} role="gridcell" />
    ))}
    <CostCell cost={table.costOf(row)} />
  </>
);
