import { t } from '@farol/editing';
import { type ReactNode, useState } from 'react';
import { useEditor } from '../../ui/EditorContext';
import { Button } from '../../ui/Button';

interface ExportButtonProps {
  readonly label: string;
  /** Description of the exported file, one line. */
  readonly note: string;
  /** Creates the file and downloads it. @returns a line for each kind of thing that the format does not support */
  run(): Promise<readonly string[]>;
}

/** A section of the export dialog for one format, which lists what was left out. */
export function ExportButton({ label, note, run }: ExportButtonProps): ReactNode {
  const editor = useEditor();
  const [isBusy, setBusy] = useState(false);
  const [lost, setLost] = useState<readonly string[]>([]);
  const start = async (): Promise<void> => {
    setBusy(true);
    setLost([]);
    try {
      setLost(await run());
    } finally {
      setBusy(false);
    }
  };
  return (
    <>
      <div className="export-row">
        <Button
          look="primary"
          label={label}
          aria-busy={isBusy}
          // `aria-disabled` in place of `disabled`, since a disabled button loses the focus
          aria-disabled={isBusy}
          onClick={() => isBusy || editor.attempt(start)}
        />
        <span className="export-note">{isBusy ? t('Being made…') : note}</span>
      </div>
      {lost.length > 0 && (
        <div className="export-lost" role="status">
          <span>{t('Not supported by glTF:')}</span>
          <ul>
            {lost.map((line) => (
              <li key={line}>{line}</li>
            ))}
          </ul>
        </div>
      )}
    </>
  );
}
