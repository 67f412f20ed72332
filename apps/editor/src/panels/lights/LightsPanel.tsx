import { t } from '@farol/editing';
import { type ReactNode, useEffect, useState } from 'react';
import type { MenuEntry } from '../../api/MenuEntry';
import { makeLightGroup, moveToLightGroup } from '../../model/lights/lightEdits';
import { kindLabel } from '../../model/lights/lightSource';
import { LightTable } from '../../model/lights/LightTable';
import { Button } from '../../ui/Button';
import { useEditor, useSignal } from '../../ui/EditorContext';
import { MenuButton } from '../../ui/MenuButton';
import { SearchInput } from '../../ui/SearchInput';
import { SelectBox } from '../../ui/SelectBox';
import { LightsGrid } from './LightsGrid';
import './lights.css';

/** Values of the filters: all lights, and lights without a group. */
const ALL = 'all';
const NO_GROUP = 'none';

const kinds = ['ambient', 'hemisphere', 'directional', 'point', 'spot', 'rectangle', 'disc', 'tube', 'particles'];

/** Table of all lights of the scene, in groups with dimmers. */
export function LightsPanel(): ReactNode {
  const editor = useEditor();
  const { document, commands } = editor;
  const [table] = useState(() => new LightTable(document));
  useEffect(() => table.connect(), [table]);
  useSignal(table.arranged);
  const [text, setText] = useState('');
  const { rows, groups, shownFilter: filter } = table;
  const shown = rows.filter(({ kind }) => kind === 'light').length;

  const entries = (): MenuEntry[] => {
    const lights = table.selected;
    const disabled = lights.length === 0;
    const grouped = lights.filter(({ group }) => group !== null);
    return [
      {
        label: t('New group of selected lights'),
        icon: 'add',
        disabled,
        run: () => commands.run(makeLightGroup(document.scene, lights, document.selection.ids)),
      },
      'separator',
      ...groups.map(({ gameObject }): MenuEntry => ({
        label: t('Put into {name}', { name: gameObject.name }),
        icon: 'sliders',
        disabled,
        run: () => commands.run(moveToLightGroup(lights, gameObject)),
      })),
      {
        label: t('Take out of group'),
        disabled: grouped.length === 0,
        run: () => commands.run(moveToLightGroup(grouped, null)),
      },
    ];
  };

  return (
    <section className="panel lights" aria-label={t('Lights')}>
      <div className="lights-bar">
        <SearchInput
          label={t('Search lights')}
          placeholder={t('Search lights')}
          value={text}
          onSearch={(next) => {
            setText(next);
            table.setFilter({ text: next });
          }}
        />
        <SelectBox
          value={filter.kind ?? ALL}
          options={[
            { value: ALL, label: t('All kinds') },
            ...kinds.map((kind) => ({ value: kind, label: kindLabel(kind) })),
          ]}
          label={t('Kind of light')}
          onChange={(kind) => table.setFilter({ kind: kind === ALL ? null : kind })}
        />
        <SelectBox
          value={filter.group === null ? ALL : filter.group || NO_GROUP}
          options={[
            { value: ALL, label: t('All groups') },
            ...groups.map(({ gameObject: { id, name } }) => ({ value: id, label: name })),
            { value: NO_GROUP, label: t('No group') },
          ]}
          label={t('Group of lights')}
          onChange={(group) => table.setFilter({ group: group === ALL ? null : group === NO_GROUP ? '' : group })}
        />
        <Button
          look="small framed"
          label={t('Selected')}
          title={t('Show only lights that are selected')}
          aria-pressed={filter.isSelected}
          onClick={() => table.setFilter({ isSelected: !filter.isSelected })}
        />
        <MenuButton label={t('Group')} icon="sliders" className="button framed" entries={entries} />
        {table.hasSolo && <Button look="primary" label={t('End solo')} onClick={() => table.endSolo()} />}
        <span className="lights-count dim">{t('{shown} of {count}', { shown, count: table.size })}</span>
      </div>
      {table.size === 0 ? (
        <p className="menu-empty">{t('No light is in the scene yet.')}</p>
      ) : (
        <LightsGrid table={table} />
      )}
    </section>
  );
}
