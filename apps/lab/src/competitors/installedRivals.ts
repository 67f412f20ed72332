/** The command that installs the other engines. */
export const installCommand = 'npm run rivals';

/** What is installed of the other engines. */
export interface InstalledRivals {
  /** Versions of their packages by competitor's key; empty when they are not installed. */
  readonly versions: Readonly<Record<string, string>>;
  /** Whether the server that the page came from installs them when asked: the one of `npm start` does. */
  readonly canInstall: boolean;
}

/** What is installed of the other engines, as the page's server says. */
export async function installedRivals(): Promise<InstalledRivals> {
  try {
    const answer = await fetch(new URL('rivals/versions.json', document.baseURI));
    if (answer.ok) return (await answer.json()) as InstalledRivals;
  } catch {
    // a server that knows nothing of them, or none
  }
  return { versions: {}, canInstall: false };
}

/**
 * Has the server of `npm start` install the other engines: some seconds to minutes, by the network.
 * @throws Error (as a rejection) with what npm said, or when the server installs nothing
 */
export async function installRivals(): Promise<void> {
  const answer = await fetch(new URL('rivals/install', document.baseURI), { method: 'POST' });
  if (!answer.ok) throw new Error(`This server installs nothing: run ${installCommand}.`);
  const { problem } = (await answer.json()) as { problem: string | null };
  if (problem !== null) throw new Error(`The other engines were not installed: ${problem}`);
}
