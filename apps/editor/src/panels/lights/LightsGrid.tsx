import { Popover } from '@base-ui/react/popover';
import { FieldGesture, t } from '@farol/editing';
import { Light, LightGroup } from '@farol/engine';
import type { Vector3Tuple } from '@farol/engine/fields';
import { useVirtualizer } from '@tanstack/react-virtual';
import { type KeyboardEvent, type MouseEvent, type ReactNode, useEffect, useMemo, useRef, useState } from 'react';
import { ColourPicker } from '../../fields/ColourPicker';
import { setEnabled } from '../../model/edits';
import type { LightRow, LightTable } from '../../model/lights/LightTable';
import { ownersName } from '../../model/ownersName';
import { useEditor, useSignal } from '../../ui/EditorContext';
import { Icon } from '../../ui/Icon';
import { FieldList } from '../inspector/FieldList';
import { lightColumns } from './lightColumns';
import { type ColourPick, LightRowView, rowState } from './LightRowView';

const isCoarse = matchMedia('(pointer: coarse)').matches;

/** Heights of a row and of the column titles (CSS pixels), larger for fingers. */
const ROW = isCoarse ? 40 : 26;
const TITLES = isCoarse ? 40 : 26;

/** Interval between calls that continue the estimate of costs (ms). */
const MEASURE = 100;

const idOf = (row: LightRow): string => `light-row-${row.id}`;

/** The table of lights; only visible rows are rendered. */
export function LightsGrid({ table }: { readonly table: LightTable }): ReactNode {
  const editor = useEditor();
  const { document, viewport } = editor;
  useSignal(table.changed);
  const { rows } = table;
  const { ids } = document.selection;
  const selected = useMemo(() => new Set(ids), [ids]);
  const grid = useRef<HTMLDivElement>(null);
  /** Id of the row with the keyboard focus; `anchor` is the row where a range begins. */
  const [active, setActive] = useState<string | null>(null);
  const anchor = useRef<string | null>(null);
  const [pick, setPick] = useState<ColourPick | null>(null);
  // oxlint-disable-next-line react/incompatible-library -- this component memoises nothing by hand that depends on it
  const virtualizer = useVirtualizer({
    count: rows.length,
    getScrollElement: () => grid.current,
    estimateSize: () => ROW,
    overscan: 6,
    scrollMargin: TITLES,
    scrollPaddingStart: TITLES,
  });
  useEffect(() => {
    const measure = (): void => {
      const { width, height } = viewport.bounds;
      const { devicePixelRatio: ratio } = window;
      table.measure({ camera: viewport.camera, width: width * ratio, height: height * ratio });
    };
    const timer = setInterval(measure, MEASURE);
    return () => clearInterval(timer);
  }, [table, viewport]);

  const at =
    active === null
      ? 0
      : Math.max(
          0,
          rows.findIndex(({ id }) => id === active),
        );
  /** Selects a row or, to extend the selection, all rows from `anchor` to that row. */
  const select = (index: number, extends_: boolean): void => {
    const row = rows.at(index);
    if (!row) return;
    setActive(row.id);
    virtualizer.scrollToIndex(index);
    const from = extends_ ? rows.findIndex(({ id }) => id === anchor.current) : -1;
    if (from < 0) anchor.current = row.id;
    const range = from < 0 ? [row] : rows.slice(Math.min(from, index), Math.max(from, index) + 1);
    document.selection.set(objectIds(range));
  };
  const choose = (row: LightRow, event: MouseEvent): void => {
    grid.current?.focus({ preventScroll: true });
    if (row.kind === 'rest') return setActive(row.id);
    if (event.shiftKey) return select(rows.indexOf(row), true);
    anchor.current = row.id;
    setActive(row.id);
    if (event.ctrlKey || event.metaKey) document.selection.toggle(row.object.id);
    else document.selection.set([row.object.id]);
  };
  const latest = useRef(choose);
  useEffect(() => {
    latest.current = choose;
  });
  const [onSelect] = useState(() => (row: LightRow, event: MouseEvent) => latest.current(row, event));

  const press = (event: KeyboardEvent): void => {
    if (event.target !== event.currentTarget || event.altKey) return;
    const row = rows.at(at);
    if (!row) return;
    const { key, shiftKey, ctrlKey, metaKey } = event;
    const page = Math.max(1, Math.floor((grid.current!.clientHeight - TITLES) / ROW) - 1);
    const steps: Record<string, number> = {
      ...{ ArrowDown: at + (active === null ? 0 : 1), ArrowUp: at - 1, Home: 0, End: rows.length - 1 },
      ...{ PageDown: at + page, PageUp: at - page },
    };
    if (key.toLowerCase() === 'a' && (ctrlKey || metaKey)) document.selection.set(objectIds(rows));
    else if (ctrlKey || metaKey) return;
    else if (key in steps) select(Math.min(rows.length - 1, Math.max(0, steps[key])), shiftKey);
    else if ((key === 'ArrowLeft' || key === 'ArrowRight') && row.kind !== 'light')
      table.fold(row.id, key === 'ArrowLeft');
    else if (key === ' ' && row.kind !== 'rest') {
      const edited = row.kind === 'light' ? row.source : row.group;
      editor.commands.run(setEnabled(table.editedBy(edited), !edited.enabled));
    } else if (key === 'Enter' && row.kind !== 'rest') viewport.focus();
    else return;
    event.preventDefault();
    event.stopPropagation();
  };

  const items = virtualizer.getVirtualItems();
  const isActiveShown = active !== null && items.some(({ index }) => index === at);
  return (
    <div
      ref={grid}
      className="lights-grid"
      role="treegrid"
      tabIndex={0}
      aria-label={t('Lights')}
      aria-multiselectable="true"
      aria-rowcount={rows.length + 1}
      aria-activedescendant={isActiveShown ? idOf(rows[at]) : undefined}
      onKeyDown={press}
    >
      <div className="lights-row lights-titles" role="row" aria-rowindex={1} style={{ height: TITLES }}>
        {lightColumns().map(({ id, title, help }) => {
          const isSorted = table.sort.column === id;
          return (
            <span
              key={id}
              role="columnheader"
              aria-sort={isSorted ? (table.sort.isDescending ? 'descending' : 'ascending') : undefined}
            >
              <button type="button" className="lights-text" title={help} onClick={() => table.sortBy(id)}>
                {title}
                {isSorted && <Icon name={table.sort.isDescending ? 'down' : 'up'} size={10} />}
              </button>
            </span>
          );
        })}
      </div>
      <div className="lights-rows" role="rowgroup" style={{ height: virtualizer.getTotalSize() }}>
        {items.map(({ index, start }) => {
          const row = rows[index];
          return (
            <LightRowView
              key={row.id}
              id={idOf(row)}
              {...{ editor, table, row, index, onSelect }}
              top={start - TITLES}
              height={ROW}
              tabIndex={index === at ? 0 : -1}
              isSelected={row.kind !== 'rest' && selected.has(row.object.id)}
              state={rowState(table, row)}
              onPick={setPick}
            />
          );
        })}
      </div>
      {pick && <Picker table={table} pick={pick} onClose={() => setPick(null)} />}
    </div>
  );
}

const objectIds = (rows: readonly LightRow[]): string[] =>
  rows.flatMap((row) => (row.kind === 'rest' ? [] : row.object.id));

/** Picker for the colour of a row, by hand or by temperature; edits all selected rows when the row is one of them. */
function Picker({ table, pick, onClose }: { table: LightTable; pick: ColourPick; onClose(): void }): ReactNode {
  const editor = useEditor();
  useSignal(table.changed);
  const { anchor, edited } = pick;
  const name = edited instanceof LightGroup ? 'colour' : 'diffuse';
  const [owners, gesture] = useMemo(() => {
    const all = table.editedBy(edited).filter((each) => name in each.fields);
    return [all, new FieldGesture(editor.commands, all, name, () => ownersName(all))] as const;
  }, [editor, table, edited, name]);
  const isByHand = !(edited instanceof Light && edited.colourBy === 'temperature');
  return (
    <Popover.Root open onOpenChange={(isOpen) => !isOpen && onClose()}>
      <Popover.Portal>
        <Popover.Positioner className="positioner" anchor={anchor} sideOffset={4} align="end">
          <Popover.Popup className="popup colour-popup lights-colour" aria-label={t('Colour')}>
            {isByHand && (
              <ColourPicker
                value={edited.getAuthored(name) as Vector3Tuple}
                mixed={false}
                label={t('Colour')}
                onPreview={(update) => editor.attempt(() => gesture.preview(update))}
                onCommit={(update) => editor.attempt(() => gesture.commit(update))}
                onAmend={(update) => editor.attempt(() => gesture.amend(update))}
                onDiscard={() => gesture.discard()}
              />
            )}
            {edited instanceof Light && <FieldList owners={owners} names={['colourBy', 'kelvin']} />}
          </Popover.Popup>
        </Popover.Positioner>
      </Popover.Portal>
    </Popover.Root>
  );
}
