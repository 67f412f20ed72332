import { Dialog } from '@base-ui/react/dialog';
import { t } from '@farol/editing';
import type { ReactNode } from 'react';
import type { RecoverDialog as RecoverRequest } from '../../model/Dialogs';
import { SessionList } from './SessionList';
import { Button } from '../../ui/Button';

/** Dialog that offers unsaved scenes of closed tabs. */
export function RecoverDialog({ request, onClose }: { request: RecoverRequest; onClose(): void }): ReactNode {
  return (
    <>
      <Dialog.Title>{t('Unsaved work was found')}</Dialog.Title>
      <Dialog.Description>{t('The editor was closed before these scenes were saved.')}</Dialog.Description>
      <SessionList offer={request} onClose={onClose} onEmpty={onClose} />
      <div className="dialog-buttons">
        <span className="dialog-hint">
          {t('Scenes left for later are kept: “Recover…” in the menu File offers them again.')}
        </span>
        <Button label={t('Later')} onClick={onClose} />
      </div>
    </>
  );
}
