import { Dialog } from '@base-ui/react/dialog';
import { t } from '@farol/editing';
import type { ReactNode } from 'react';
import { REVISION } from 'three';
import { useEditor } from '../../ui/EditorContext';
import { Button } from '../../ui/Button';

/** Name of the licence, not translated. */
const LICENCE = 'MIT';

/** Shows the editor's purpose, the device it runs on, and its licence. */
export function AboutDialog({ onClose }: { onClose(): void }): ReactNode {
  const { viewport } = useEditor();
  const gl = viewport.webgl.getContext();
  const device = gl.getExtension('WEBGL_debug_renderer_info');
  const name = String(gl.getParameter(device?.UNMASKED_RENDERER_WEBGL ?? gl.RENDERER));
  const techniques = Object.keys(viewport.farol.techniques).length;
  return (
    <>
      <Dialog.Title>{t('About Farol')}</Dialog.Title>
      <Dialog.Description>
        {t('An editor of three.js scenes with very many lights, drawn by {techniques} techniques.', { techniques })}
      </Dialog.Description>
      <dl className="about">
        <dt>three.js</dt>
        <dd>r{REVISION}</dd>
        <dt>{t('Graphics device')}</dt>
        <dd>{name}</dd>
        <dt>{t('Licence')}</dt>
        <dd>{LICENCE}</dd>
      </dl>
      <div className="dialog-buttons">
        <Button label={t('Close')} onClick={onClose} />
      </div>
    </>
  );
}
