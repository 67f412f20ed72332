import { t } from '@farol/editing';
import { Dialog } from '@base-ui/react/dialog';
import { type ReactNode, useState } from 'react';
import { renderSVG } from 'uqr';
import { endShare, looksText, shareOf } from '../../files/live/LiveShare';
import { useEditor, useSignal } from '../../ui/EditorContext';
import { Button } from '../../ui/Button';
import { CopyButton } from './CopyButton';

/** Command that starts the dev server with access for phones, not translated. */
const COMMAND = 'npm start -- --host';

/** Scrolls to the end of a long address, where addresses differ. */
const showEnd = (input: HTMLInputElement | null): void => {
  if (input) input.scrollLeft = input.scrollWidth;
};

/** Address and QR code of the scene, for a phone or a headset, which then shows each edit. */
export function PhoneDialog({ onClose }: { onClose(): void }): ReactNode {
  const editor = useEditor();
  const [share] = useState(() => shareOf(editor));
  useSignal(share.changed);
  const [place, setPlace] = useState(0);
  const { addresses } = share;
  const isAlone = addresses?.length === 0;
  const address = addresses?.[Math.min(place, addresses.length - 1)];
  const stop = (): void => {
    endShare(editor);
    onClose();
  };
  return (
    <>
      <Dialog.Title>{t('Open on a phone')}</Dialog.Title>
      {!addresses && <p role="status">{t('Asking the server for its address…')}</p>}
      {isAlone && (
        <>
          <p>{t('This server answers only this machine. Stop it, and start it for your network by:')}</p>
          <div className="export-row">
            <input className="input" type="text" readOnly value={COMMAND} aria-label={t('Command')} />
            <CopyButton text={COMMAND} label={t('Command')} />
          </div>
        </>
      )}
      {addresses && address && (
        <>
          <Dialog.Description>
            {t(
              'A phone or a headset in the same network shows the scene under this address, and follows each edit. Only those who have the address can look.',
            )}
          </Dialog.Description>
          <img
            className="phone-code"
            src={`data:image/svg+xml,${encodeURIComponent(renderSVG(address, { border: 4 }))}`}
            alt={t('QR code of the address')}
          />
          {addresses.length > 1 && (
            <div className="export-row">
              {addresses.map((each, i) => (
                <Button
                  key={each}
                  label={new URL(each).hostname}
                  aria-pressed={each === address}
                  onClick={() => setPlace(i)}
                />
              ))}
            </div>
          )}
          <div className="export-row">
            <input
              key={address}
              className="input"
              type="text"
              readOnly
              value={address}
              aria-label={t('Address for the phone')}
              ref={showEnd}
            />
            <CopyButton text={address} label={t('Address')} />
          </div>
          <p className="export-note">
            {t(
              'The phone warns once that it does not know the certificate, which this machine made: choose Advanced, on an iPhone Show Details, and go on to the page.',
            )}
          </p>
          <p role="status">{looksText(share.looks)}</p>
        </>
      )}
      <div className="dialog-buttons">
        {address && <Button label={t('Stop showing')} onClick={stop} />}
        <Button label={t('Close')} onClick={onClose} />
      </div>
    </>
  );
}
