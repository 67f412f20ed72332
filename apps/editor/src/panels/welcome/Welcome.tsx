import { Dialog } from '@base-ui/react/dialog';
import { t } from '@farol/editing';
import { collectFiles, type FileMap } from '@farol/engine/files';
import { type ReactNode, useState } from 'react';
import type { Action } from '../../api/Action';
import { newScene, open } from '../../actions/file';
import { startTour } from '../../actions/help';
import { isFileDrag } from '../../files/dragAsset';
import type { WelcomeDialog } from '../../model/Dialogs';
import { useEditor, useSignal } from '../../ui/EditorContext';
import { Icon } from '../../ui/Icon';
import { IconButton } from '../../ui/IconButton';
import { useDropTarget } from '../../ui/useDropTarget';
import { usePreferences } from '../../ui/usePreferences';
import type { IconName } from '../../style/iconPaths';
import { SessionList } from '../dialogs/SessionList';
import { RecentCards } from './RecentCards';
import { SampleCards } from './SampleCards';
import './welcome.css';
import { Button } from '../../ui/Button';

interface WelcomeProps {
  readonly request: WelcomeDialog;
  onClose(): void;
}

/** Welcome page: unsaved work, recent files, samples, an empty scene, a model, the tour. */
export function Welcome({ request, onClose }: WelcomeProps): ReactNode {
  const editor = useEditor();
  const isShown = usePreferences(({ showWelcome }) => showWelcome);
  useSignal(editor.fileChanged);
  const [isEmpty, setEmpty] = useState(false);
  // sessions to recover may arrive while the page is open
  const offer = isEmpty ? null : request.recovery;
  const run = (action: Action): void => {
    onClose();
    editor.attempt(() => action.run(editor));
  };
  const start = (files: Promise<FileMap> | FileMap): void => {
    onClose();
    editor.attempt(async () => {
      const { startWith } = await import('../../files/startWith');
      await startWith(editor, await files);
    });
  };
  const target = useDropTarget(isFileDrag, (data) => start(collectFiles(data)));
  return (
    <div className="welcome" {...target}>
      <header className="welcome-header">
        <Icon name="lamp" size={26} />
        <div>
          <Dialog.Title>{t('Welcome to Farol')}</Dialog.Title>
          <Dialog.Description>{t('Scenes with very many lights, in the browser.')}</Dialog.Description>
        </div>
        <IconButton icon="close" size={16} className="button" label={t('Close')} onClick={onClose} />
      </header>
      <div className="welcome-body">
        {offer && (
          <section aria-label={t('Unsaved work was found')}>
            <h3>{t('Unsaved work was found')}</h3>
            <SessionList offer={offer} onClose={onClose} onEmpty={() => setEmpty(true)} />
          </section>
        )}
        <div className="welcome-starts">
          <Start
            icon="add"
            label={t('Empty scene')}
            help={t('A camera, a sun and a sky')}
            onClick={() => run(newScene)}
          />
          <Start icon="open" label={t('Open a scene…')} help={t('A .farol file')} onClick={() => run(open)} />
          <label className="welcome-start welcome-drop">
            <Icon name="mesh" size={20} />
            <span className="welcome-words">
              {t('Drop a model here')}
              <span>{t('glTF, OBJ, STL… or choose files')}</span>
            </span>
            <input
              type="file"
              multiple
              aria-label={t('Choose files of a model')}
              onChange={({ target }) =>
                target.files?.length && start(new Map([...target.files].map((file) => [file.name, file])))
              }
            />
          </label>
          <Start
            icon="eye"
            label={t('Two-minute tour')}
            help={t('Leave it at any step')}
            onClick={() => run(startTour)}
          />
        </div>
        <RecentCards onClose={onClose} />
        <SampleCards onClose={onClose} />
      </div>
      <footer className="welcome-footer">
        <label>
          <input
            type="checkbox"
            checked={isShown}
            onChange={({ target }) => editor.preferences.setState({ showWelcome: target.checked })}
          />
          {t('Show at start')}
        </label>
        <Button label={t('Go on with “{scene}”', { scene: editor.document.scene.name })} onClick={onClose} />
      </footer>
    </div>
  );
}

interface StartProps {
  readonly icon: IconName;
  readonly label: string;
  readonly help: string;
  onClick(): void;
}

function Start({ icon, label, help, onClick }: StartProps): ReactNode {
  return (
    <button type="button" className="welcome-start" onClick={onClick}>
      <Icon name={icon} size={20} />
      <span className="welcome-words">
        {label}
        <span>{help}</span>
      </span>
    </button>
  );
}
