import { t } from '@farol/editing';
import type { ReactNode } from 'react';
import { addEntries } from '../../actions/addEntries';
import { duplicate, redo, remove, undo } from '../../actions/edit';
import { open, save } from '../../actions/file';
import { otherApps, showKeys } from '../../actions/help';
import { labelOf } from '../../api/Action';
import { pause, play, step, stop } from '../../actions/play';
import { ActionButton } from '../../ui/ActionButton';
import { useEditor, useSignal } from '../../ui/EditorContext';
import { MenuButton } from '../../ui/MenuButton';
import { LateSelectBox as SelectBox } from '../../ui/LateSelectBox';
import { useMedia } from '../../ui/useMedia';
import { techniqueOptions } from '../../ui/techniqueOptions';
import { viewOptions } from '../../ui/viewOptions';
import { MenuBar } from './MenuBar';
import { ThemeButton } from './ThemeButton';
import './toolbar.css';

/** The top bar: file, history, Add menu, playback, technique and view. */
export function Toolbar(): ReactNode {
  const editor = useEditor();
  const { document, viewport, commands } = editor;
  const isNarrow = useMedia('(max-width: 699px)');
  useSignal(commands.changed);
  useSignal(document.selection.changed);
  useSignal(document.simulation.changed);
  useSignal(viewport.changed);
  return (
    <header className="toolbar">
      <div className="toolbar-part">
        <MenuButton
          label="Farol"
          icon="lamp"
          className="button brand"
          entries={() =>
            otherApps.map((action) => ({
              label: labelOf(action, editor),
              run: () => editor.attempt(() => action.run(editor)),
            }))
          }
        />
        <MenuBar />
        <div className="button-group" role="toolbar" aria-label={t('File and history')}>
          <span className="toolbar-extra narrow">
            <ActionButton action={open} />
            <ActionButton action={save} />
            <span className="bar-line" />
          </span>
          <ActionButton action={undo} />
          <ActionButton action={redo} />
          <span className="toolbar-extra">
            <span className="bar-line" />
            <ActionButton action={duplicate} />
            <ActionButton action={remove} />
          </span>
        </div>
        <MenuButton
          label={t('Add')}
          icon="add"
          iconOnly={isNarrow}
          className="button toolbar-add"
          entries={() => addEntries(editor)}
        />
      </div>
      <div className="button-group play" role="toolbar" aria-label={t('Simulation')}>
        {[play, pause, step, stop].map((action) => (
          <ActionButton key={action.id} action={action} />
        ))}
      </div>
      <div className="toolbar-part end">
        <div className="labelled technique">
          <span aria-hidden="true">{t('Technique')}</span>
          <SelectBox
            value={viewport.technique}
            options={techniqueOptions(viewport.farol)}
            label={t('Technique')}
            onChange={(technique) =>
              editor.attempt(() => {
                viewport.technique = technique;
              })
            }
          />
        </div>
        <div className="labelled">
          <span aria-hidden="true">{t('View')}</span>
          <SelectBox
            value={viewport.view}
            options={viewOptions()}
            label={t('View')}
            onChange={(view) =>
              editor.attempt(() => {
                viewport.view = view;
              })
            }
          />
        </div>
        <ThemeButton />
        <ActionButton action={showKeys} />
      </div>
    </header>
  );
}
