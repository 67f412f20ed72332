import { t } from '@farol/editing';
import { Dialog } from '@base-ui/react/dialog';
import { type ReactNode, useEffect, useState } from 'react';
import { allowAgents, linkOf, linksChanged } from '../../agent/AgentLink';
import { Button } from '../../ui/Button';
import { useEditor, useSignal } from '../../ui/EditorContext';
import { CopyButton } from './CopyButton';
import '../agent/agent.css';

/** Command that starts a server that accepts agents, not translated. */
const COMMAND = 'npm start';

/** Command by which an MCP client starts the server: a script that the dev server names, else that of the package. */
async function startOf(): Promise<{ command: string; args: readonly string[] }> {
  try {
    const { agent } = (await (await fetch('./apps.json')).json()) as { agent?: string };
    if (agent) return { command: 'node', args: [agent] };
  } catch {
    // a page served from a plain folder has no apps.json: the package's command is used
  }
  return { command: 'npx', args: ['-y', '-p', '@farol/mcp', 'farol-mcp'] };
}

/** Asks whether agents may edit, and shows the settings with which an MCP client connects to the editor. */
export function AgentDialog({ onClose }: { onClose(): void }): ReactNode {
  const editor = useEditor();
  useSignal(linksChanged);
  const link = linkOf(editor);
  const [setting, setSetting] = useState('');
  const [isServed, setServed] = useState(true);
  useEffect(() => {
    void startOf().then(({ command, args }) => {
      const start = `"command": ${JSON.stringify(command)}, "args": ${JSON.stringify(args)}`;
      setSetting(`{ "mcpServers": { "farol": {\n  ${start}\n} } }`);
    });
  }, []);
  const allow = async (): Promise<void> => {
    if (await allowAgents(editor)) onClose();
    else setServed(false);
  };
  const end = (): void => {
    link?.end();
    onClose();
  };
  return (
    <>
      <Dialog.Title>{t('Let an agent edit')}</Dialog.Title>
      <Dialog.Description>
        {t(
          'A program on this computer that speaks the Model Context Protocol may then read this scene and its messages, see its picture, edit it and run the commands of the menus. Each of its calls is one step that you can undo.',
        )}
      </Dialog.Description>
      <p>{t('A bar is shown while agents may edit. Its button ends that, as does closing or reloading this tab.')}</p>
      {isServed ? (
        <>
          {/* oxlint-disable-next-line jsx-a11y/no-noninteractive-tabindex -- a scrolling text must be reachable by keyboard */}
          <pre className="agent-setting" tabIndex={0} aria-label={t('Setting of the MCP client')}>
            {setting}
          </pre>
        </>
      ) : (
        <>
          <p role="alert">{t('Agents reach this page only where npm start serves it. Start the editor like this:')}</p>
          <div className="export-row">
            <input className="input" type="text" readOnly value={COMMAND} aria-label={t('Command')} />
            <CopyButton text={COMMAND} label={t('Command')} />
          </div>
        </>
      )}
      <div className="dialog-buttons">
        {isServed && <CopyButton text={setting} label={t('Setting')} />}
        <Button label={t('Close')} onClick={onClose} />
        {link && <Button label={t('End it')} onClick={end} />}
        {!link && isServed && <Button look="primary" label={t('Allow it')} onClick={() => editor.attempt(allow)} />}
      </div>
    </>
  );
}
