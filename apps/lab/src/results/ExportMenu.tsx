import { t } from '@farol/editing';
import { useEffect, useRef, useState } from 'preact/hooks';
import { messageOf } from '../run/messageOf';
import { exportFormats, type ExportFormat } from './exportRun';
import type { LabRun } from './LabRun';
import { saveFile } from './saveFile';
import './results.css';

interface ExportMenuProps {
  run: LabRun;
  /** Address that restores the run's configuration; null if there is none, as for a handed-over scene. */
  link?: string | null;
}

/** Menu to save a run as a file, copy it as Markdown, or copy a link to its configuration. */
export function ExportMenu({ run, link = null }: ExportMenuProps) {
  const details = useRef<HTMLDetailsElement>(null);
  const summary = useRef<HTMLElement>(null);
  const [message, setMessage] = useState<{ text: string; isProblem: boolean } | null>(null);
  useEffect(() => {
    const onPointer = ({ target }: PointerEvent): void => {
      if (details.current?.open && !details.current.contains(target as Node)) details.current.open = false;
    };
    addEventListener('pointerdown', onPointer);
    return () => removeEventListener('pointerdown', onPointer);
  }, []);
  useEffect(() => setMessage(null), [run]);

  const act = async (work: () => Promise<string>): Promise<void> => {
    setMessage(null);
    if (details.current) details.current.open = false;
    summary.current?.focus();
    try {
      setMessage({ text: await work(), isProblem: false });
    } catch (error) {
      setMessage({ text: messageOf(error), isProblem: true });
    }
  };
  const save = (format: ExportFormat) =>
    act(async () => {
      const { name, content } = await format.make(run);
      saveFile(name, content);
      return t('{name} is made.', { name });
    });
  const copy = (done: string, write: () => Promise<string>) =>
    act(async () => {
      const text = await write();
      await navigator.clipboard.writeText(text).catch(() => {
        throw new Error(t('The browser does not allow access to the clipboard: export a file.'));
      });
      return done;
    });

  return (
    <div class="export">
      <details
        ref={details}
        class="export-menu"
        onToggle={({ currentTarget }) => currentTarget.open && keepInside(currentTarget.querySelector('ul')!)}
        onKeyDown={({ key }) => {
          if (key !== 'Escape' || !details.current?.open) return;
          details.current.open = false;
          summary.current?.focus();
        }}
      >
        <summary ref={summary} class="button">
          {t('Export')}
        </summary>
        <ul>
          {Object.entries(exportFormats).map(([key, format]) => (
            <li key={key}>
              <ExportButton label={format.label} help={t(format.help)} onClick={() => void save(format)} />
            </li>
          ))}
          <li>
            <ExportButton
              label={t('Copy Markdown')}
              help={t('The same tables, for an issue or a message.')}
              onClick={() =>
                void copy(t('The Markdown is in the clipboard.'), async () =>
                  (await import('./runMarkdown')).runMarkdown(run),
                )
              }
            />
          </li>
          {link !== null && (
            <li>
              <ExportButton
                label={t('Copy link')}
                help={t('An address that restores what was measured, without the figures.')}
                onClick={() => void copy(t('The link is in the clipboard.'), async () => link)}
              />
            </li>
          )}
        </ul>
      </details>
      <p role={message?.isProblem ? 'alert' : 'status'} class={message?.isProblem ? 'problem' : 'dim'}>
        {message?.text}
      </p>
    </div>
  );
}

/** Moves a menu to the left so that it is within the page. */
function keepInside(menu: HTMLElement): void {
  menu.style.left = '0';
  const { right } = menu.getBoundingClientRect();
  menu.style.left = `${Math.min(0, document.documentElement.clientWidth - 12 - right)}px`;
}

function ExportButton({ label, help, onClick }: { label: string; help: string; onClick(): void }) {
  return (
    <button type="button" class="export-item" onClick={onClick}>
      <span>{label}</span>
      <span class="dim">{help}</span>
    </button>
  );
}
