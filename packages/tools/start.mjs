/**
 * `npm start`: installs what is missing, serves the editor, the viewer and the Lab from source, opens the editor.
 *
 * The editor is on port 5173, or FAROL_PORT; the viewer on the next one, the Lab on the one after.
 */
import { spawn } from 'node:child_process';
import { ensureInstalled } from './ensureInstalled.mjs';
import { serveApps } from './serveApps.mjs';

const port = Number(process.env.FAROL_PORT || 5173);
if (!Number.isInteger(port) || port < 1 || port > 65533) {
  console.error(`FAROL_PORT is ${process.env.FAROL_PORT}: give a whole number from 1 to 65533.`);
  process.exit(1);
}

ensureInstalled();
try {
  const { urls } = await serveApps({ ports: { editor: port, viewer: port + 1, lab: port + 2 } });
  console.log(
    `\n  Farol editor  ${urls.editor}\n  Farol viewer  ${urls.viewer}\n  Examples      ${urls.viewer}examples/\n  Farol Lab     ${urls.lab}\n\n  Ctrl+C stops them.\n`,
  );
  if (urls.editor) openBrowser(urls.editor);
} catch (error) {
  const message = error instanceof Error ? error.message : String(error);
  const taken = /port (\d+) is already in use/i.exec(message);
  const refused = /listen EACCES.*:(\d+)/.exec(message);
  console.error(
    refused
      ? `This machine lets no program of yours listen on port ${refused[1]}: choose ports above 1023, for example: FAROL_PORT=5300 npm start`
      : taken
        ? `Port ${taken[1]} is taken by another program (another npm start?). Stop it, or choose three free ports in a row, for example: FAROL_PORT=5300 npm start`
        : message,
  );
  process.exit(1);
}

/** Opens the desktop's browser where there is one; says nothing when it cannot. @param {string} url */
function openBrowser(url) {
  const desktop = process.platform !== 'linux' || process.env.DISPLAY || process.env.WAYLAND_DISPLAY;
  if (!process.stdout.isTTY || process.env.CI || !desktop) return;
  const [command, ...args] =
    process.platform === 'darwin'
      ? ['open', url]
      : process.platform === 'win32'
        ? ['cmd', '/c', 'start', '', url]
        : ['xdg-open', url];
  spawn(command, args, { stdio: 'ignore', detached: true })
    .on('error', () => {})
    .unref();
}
