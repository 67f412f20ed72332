/**
 * `npm start`: installs what is missing, serves the editor, the viewer, the Lab and the site from source, opens the editor.
 *
 * The editor is on port 5173, or FAROL_PORT; viewer, Lab and site on those after it. `npm start -- --host` serves editor,
 * viewer and Lab to the network as well, over HTTPS on the three ports that follow.
 */
import { spawn } from 'node:child_process';
import { ensureInstalled } from './ensureInstalled.mjs';
import { noteAgentPlace } from './reach/agentPlace.mjs';
import { serveApps } from './serveApps.mjs';

const unknown = process.argv.slice(2).filter((each) => each !== '--host');
if (unknown.length > 0) {
  console.error(`npm start knows --host alone, which serves to the network as well; not ${unknown.join(' ')}.`);
  process.exit(1);
}
const isHost = process.argv.includes('--host');
const port = Number(process.env.FAROL_PORT || 5173);
if (!Number.isInteger(port) || port < 1 || port > 65529) {
  console.error(`FAROL_PORT is ${process.env.FAROL_PORT}: give a whole number from 1 to 65529.`);
  process.exit(1);
}

ensureInstalled();
try {
  const { urls, networkUrls, agentKey } = await serveApps({
    ports: { editor: port, viewer: port + 1, lab: port + 2, site: port + 3 },
    network: isHost ? { editor: port + 4, viewer: port + 5, lab: port + 6 } : {},
  });
  console.log(
    `\n  Farol editor  ${urls.editor}\n  Farol viewer  ${urls.viewer}\n  Farol Lab     ${urls.lab}\n  Farol's site  ${urls.site}\n  Examples      ${urls.site}gallery/\n\n  Ctrl+C stops them.\n`,
  );
  noteAgentPlace(String(urls.editor), agentKey);
  if (isHost) await tellNetwork(networkUrls);
  if (urls.editor) openBrowser(urls.editor);
} catch (error) {
  const message = error instanceof Error ? error.message : String(error);
  const taken = /port (\d+) is already in use/i.exec(message);
  const refused = /listen EACCES.*:(\d+)/.exec(message);
  console.error(
    refused
      ? `This machine lets no program of yours listen on port ${refused[1]}: choose ports above 1023, for example: FAROL_PORT=5300 npm start`
      : taken
        ? `Port ${taken[1]} is taken by another program (another npm start?). Stop it, or choose free ports in a row (four, seven with --host), for example: FAROL_PORT=5300 npm start`
        : message,
  );
  process.exit(1);
}

/** Prints the addresses in the network, and the editor's first one as a QR code. @param {import('./serveApps.mjs').AppUrls[]} places */
async function tellNetwork(places) {
  const { renderUnicodeCompact } = await import('uqr');
  if (places.length === 0) console.log('  This machine is in no network: nobody else can open an address.\n');
  for (const { editor, viewer, lab } of places)
    console.log(`  In the network: ${editor}\n    viewer ${viewer}\n    Lab ${lab}`);
  if (places[0]?.editor) console.log(renderUnicodeCompact(places[0].editor, { border: 2 }));
  console.log(
    '  Whoever has such an address, token included, sees and reads what is served. A phone warns of the certificate, which is\n  of this machine alone, once: choose Advanced (iPhone: Show Details), then to go on to the page.\n',
  );
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
