import { FieldGesture, t, tCount } from '@farol/editing';
import { Light, type LightGroup } from '@farol/engine';
import { memo, type MouseEvent, type ReactNode } from 'react';
import type { EditorApi } from '../../api/EditorApi';
import { setEnabled } from '../../model/edits';
import {
  colourOf,
  columnFields,
  type FieldColumn,
  kindLabel,
  kindOf,
  lightCount,
  type LightSource,
  shownNumber,
  temperatureText,
} from '../../model/lights/lightSource';
import type { LightRow, LightTable } from '../../model/lights/LightTable';
import { ownersName } from '../../model/ownersName';
import { Icon } from '../../ui/Icon';
import { CheckCell, ColourCell, CostCell, SoloCell } from './cells';
import { GroupCells, RestCells } from './GroupRow';
import { NumberCell } from './NumberCell';
import { useRowEdit } from './useRowEdit';

/** A colour that is being picked: the element that the picker opens beside, and the component that has the colour. */
export interface ColourPick {
  readonly anchor: HTMLElement;
  readonly edited: LightSource | LightGroup;
}

export interface RowProps {
  readonly editor: EditorApi;
  readonly table: LightTable;
  readonly row: LightRow;
  /** 0 in the row that has the keyboard focus, else -1. */
  readonly tabIndex: number;
  readonly isSelected: boolean;
  onPick(pick: ColourPick): void;
}

interface LightRowViewProps extends RowProps {
  readonly id: string;
  readonly index: number;
  /** Distance of the row from the top of all rows; `height` is the row's height (CSS pixels). */
  readonly top: number;
  readonly height: number;
  /** Text of `rowState`; the row is rendered again when it changes. */
  readonly state: string;
  onSelect(row: LightRow, event: MouseEvent): void;
}

/** Everything that a row shows, as one text to compare. */
export function rowState(table: LightTable, row: LightRow): string {
  if (row.kind === 'rest') return `${row.count} ${table.isFolded('')} ${table.costOf(row).toFixed(4)}`;
  const { name, activeInHierarchy } = row.object;
  if (row.kind === 'group') {
    const { group, count } = row;
    const solo = table.areSolo(table.membersOf(row.id));
    return [
      name,
      activeInHierarchy,
      group.enabled,
      group.dimmer,
      group.colour,
      count,
      table.isFolded(row.id),
      solo,
      table.costOf(row).toFixed(4),
    ].join('\n');
  }
  const { source } = row;
  const [intensity, range] = [shownNumber(source, 'intensity'), shownNumber(source, 'range')];
  return [
    ...[name, activeInHierarchy, source.enabled, kindOf(source), table.areSolo([source]), table.isGrouped],
    ...[colourOf(source), temperatureText(source), intensity?.value, intensity?.unit, range?.value],
    ...[source instanceof Light && source.castShadow, lightCount(source), table.costOf(row).toFixed(4)],
  ].join('\n');
}

/** One row of the table. */
export const LightRowView = memo(function LightRowView(props: LightRowViewProps): ReactNode {
  const { row, id, index, top, height, onSelect, isSelected, editor, table } = props;
  const isHead = row.kind !== 'light';
  const classes = ['lights-row', isSelected && 'selected', isHead && 'lights-head', isInactive(row) && 'inactive'];
  return (
    <div
      id={id}
      role="row"
      aria-rowindex={index + 2}
      aria-level={isHead || !table.isGrouped ? 1 : 2}
      aria-expanded={isHead ? !table.isFolded(row.id) : undefined}
      aria-selected={isSelected}
      className={classes.filter(Boolean).join(' ')}
      style={{ height, transform: `translateY(${top}px)` }}
      onClick={(event) => !(event.target as Element).closest('button, input, .slider') && onSelect(row, event)}
      onDoubleClick={(event) => {
        if (row.kind !== 'rest' && !(event.target as Element).closest('button, input, .slider'))
          editor.viewport.focus();
      }}
    >
      {row.kind === 'light' && <LightCells {...props} row={row} />}
      {row.kind === 'group' && <GroupCells {...props} row={row} />}
      {row.kind === 'rest' && <RestCells {...props} row={row} />}
    </div>
  );
});

const isInactive = (row: LightRow): boolean =>
  row.kind === 'light' ? !row.source.isActive : row.kind === 'group' && !row.group.isActive;

/** Gesture that edits a column of a light, or of all selected lights when it is one of them. */
function columnGesture({ editor, table }: RowProps, source: LightSource, column: FieldColumn): FieldGesture {
  const owners = table.editedBy(source).filter((each) => columnFields[column](each) !== null);
  return new FieldGesture(
    editor.commands,
    owners,
    (owner) => columnFields[column](owner as LightSource)!,
    () => ownersName(owners),
  );
}

function LightCells({ row, ...desk }: RowProps & { readonly row: LightRow & { kind: 'light' } }): ReactNode {
  const { editor, table, tabIndex } = desk;
  const { source, object } = row;
  const { name } = object;
  const labelled = (column: string): string => t('{column} of {name}', { column, name });
  const shadow = columnFields.shadow(source);
  const colour = colourOf(source);
  return (
    <>
      <CheckCell
        label={t('{name} on', { name })}
        isOn={source.enabled}
        tabIndex={tabIndex}
        onChange={(isOn) => editor.commands.run(setEnabled(table.editedBy(source), isOn))}
      />
      <SoloCell
        name={name}
        isOn={table.areSolo([source])}
        tabIndex={tabIndex}
        onChange={(isOn) => table.setSolo(table.editedBy(source), isOn)}
      />
      <span role="gridcell" className="lights-name">
        <Icon name={kindOf(source) as 'point'} size={14} />
        <span className="row-name one-line">{name}</span>
      </span>
      <span role="gridcell" title={kindLabel(kindOf(source))}>
        {source instanceof Light
          ? kindLabel(kindOf(source))
          : tCount(lightCount(source), '{count} light', '{count} lights')}
      </span>
      {colour === null ? (
        <span role="gridcell" />
      ) : (
        <ColourCell
          label={labelled(t('Colour'))}
          colour={colour}
          text={temperatureText(source)}
          tabIndex={tabIndex}
          onPick={(anchor) => desk.onPick({ anchor, edited: source })}
        />
      )}
      <FieldCell {...desk} row={row} column="intensity" label={labelled(t('Intensity'))} isDimmed />
      <FieldCell {...desk} row={row} column="range" label={labelled(t('Range'))} />
      {shadow === null ? (
        <span role="gridcell" />
      ) : (
        <CheckCell
          label={labelled(t('Shadow'))}
          isOn={source.getAuthored(shadow) === true}
          tabIndex={tabIndex}
          onChange={(isOn) => editor.attempt(() => columnGesture({ ...desk, row }, source, 'shadow').commit(isOn))}
        />
      )}
      <CostCell cost={table.costOf(row)} />
    </>
  );
}

interface FieldCellProps extends RowProps {
  readonly row: LightRow & { kind: 'light' };
  readonly column: 'intensity' | 'range';
  readonly label: string;
  readonly isDimmed?: boolean;
}

/** A light's number. Dragging its dimmer multiplies the values of all selected rows; typing sets all to one value. */
function FieldCell({ row, column, label, isDimmed = false, ...desk }: FieldCellProps): ReactNode {
  const { editor, tabIndex } = desk;
  const { source } = row;
  const shown = shownNumber(source, column);
  const edit = useRowEdit(editor, () => columnGesture({ ...desk, row }, source, column));
  if (shown === null) return <span role="gridcell" />;
  const { fromShown, ...number } = shown;
  return (
    <span role="gridcell">
      <NumberCell
        {...number}
        label={label}
        dimmer={isDimmed ? 'own' : undefined}
        tabIndex={tabIndex}
        onDim={(next, start) =>
          edit.onPreview((before) => (start > 0 ? (before as number) * (next / start) : fromShown(next)))
        }
        {...edit}
        onPreview={(next) => edit.onPreview((_, owner) => shownNumber(owner as LightSource, column)!.fromShown(next))}
      />
    </span>
  );
}
