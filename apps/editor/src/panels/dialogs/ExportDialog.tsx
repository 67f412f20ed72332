import { t } from '@farol/editing';
import { Dialog } from '@base-ui/react/dialog';
import { type ReactNode, useEffect, useState } from 'react';
import { fileNameOf } from '../../files/fileNameOf';
import { download } from '../../files/share/download';
import { embedCode } from '../../files/share/embedCode';
import { exportGltf } from '../../files/share/exportGltf';
import { exportHtml } from '../../files/share/exportHtml';
import type { ShareOptions } from '../../files/share/sharedContent';
import { linkHash } from '../../files/share/shareLink';
import type { EditorApi } from '../../api/EditorApi';
import { useEditor } from '../../ui/EditorContext';
import { Icon } from '../../ui/Icon';
import { CopyButton } from './CopyButton';
import { ExportButton } from './ExportButton';
import { Button } from '../../ui/Button';

async function saveHtml({ document, notices }: EditorApi, options: ShareOptions): Promise<readonly string[]> {
  const fileName = `${fileNameOf(document.scene.name)}.html`;
  await download(await exportHtml(document.scene, options), fileName, t('Web page'));
  notices.show('info', t('Exported {fileName}', { fileName }));
  return [];
}

async function saveGltf({ document, notices, viewport, timeline }: EditorApi): Promise<readonly string[]> {
  const fileName = `${fileNameOf(document.scene.name)}.glb`;
  // values shown by the timeline's preview must not be exported
  timeline?.endPreview();
  const { blob, leftOut } = await exportGltf(document.scene, viewport.webgl);
  await download(blob, fileName, t('glTF binary'));
  notices.show('info', t('Exported {fileName}', { fileName }));
  return leftOut;
}

/** The scene as a link, or why it cannot be one. */
function useLink(editor: EditorApi, withScripts: boolean): { hash: string | null; problem: string | null } {
  const [link, setLink] = useState<{ hash: string | null; problem: string | null }>({ hash: null, problem: null });
  useEffect(() => {
    let isWanted = true;
    linkHash(editor.document.scene, { withScripts }).then(
      (hash) => isWanted && setLink({ hash, problem: null }),
      (error: Error) => isWanted && setLink({ hash: null, problem: error.message }),
    );
    return () => {
      isWanted = false;
    };
  }, [editor, withScripts]);
  return link;
}

/** Exports the scene: as a page, a model, a link, or a frame for another page. */
export function ExportDialog({ onClose }: { onClose(): void }): ReactNode {
  const editor = useEditor();
  const { scene, scripts } = editor.document;
  const { name } = scene;
  // scripts that are off here are exported only if the user agrees, since they would run for everybody
  const areOff = scripts.areThere && !scripts.isOn;
  const [areTaken, setTaken] = useState(false);
  const withScripts = !areOff || areTaken;
  const { hash, problem } = useLink(editor, withScripts);
  const here = new URL(location.href);
  here.search = here.hash = '';
  const link = hash && here.href + hash;
  const frame = embedCode(hash ? new URL('player.html', here).href + hash : `${fileNameOf(name)}.html`, name);
  return (
    <>
      <Dialog.Title>{t('Export {name}', { name })}</Dialog.Title>
      {areOff && (
        <label className="export-row">
          <input type="checkbox" checked={areTaken} onChange={({ target }) => setTaken(target.checked)} />
          {t('With the scripts, which are off here: a web page runs them for everybody who opens it')}
        </label>
      )}
      <section className="export-part" aria-label={t('Link')}>
        <h3>{t('Link')}</h3>
        {!problem && (
          <div className="export-row">
            <input className="input" type="text" readOnly value={link ?? ''} aria-label={t('Link to the scene')} />
            <CopyButton text={link ?? ''} label={t('Link')} disabled={!link} />
          </div>
        )}
        {problem && (
          <p className="export-row" role="alert">
            <Icon name="warning" />
            <span>{problem}</span>
          </p>
        )}
      </section>
      <section className="export-part" aria-label={t('Web page')}>
        <ExportButton
          label={t('Web page…')}
          note={t('One file with script, scene and assets; runs from a disk too.')}
          run={() => saveHtml(editor, { withScripts })}
        />
      </section>
      <section className="export-part" aria-label="glTF">
        <ExportButton
          label={t('glTF (GLB)…')}
          note={t('Objects, meshes, materials, cameras and lights for other programs.')}
          run={() => saveGltf(editor)}
        />
      </section>
      <section className="export-part" aria-label={t('Embed code')}>
        <h3>{t('Embed code')}</h3>
        {!hash && (
          <span className="export-note">
            {t('Put the exported web page beside your own, and this code into yours:')}
          </span>
        )}
        <textarea readOnly value={frame} aria-label={t('Embed code')} />
        <div className="export-row">
          <CopyButton text={frame} label={t('Embed code')} />
        </div>
      </section>
      <div className="dialog-buttons">
        <Button label={t('Close')} onClick={onClose} />
      </div>
    </>
  );
}
