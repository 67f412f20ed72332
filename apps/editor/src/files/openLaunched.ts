import type { EditorApi } from '../api/EditorApi';

/** Opens files that the system hands to the installed app. @see Web App Launch Handler API */
export function openLaunched(editor: EditorApi): void {
  const { launchQueue } = window as unknown as {
    launchQueue?: { setConsumer(take: (launch: { files: readonly FileSystemFileHandle[] }) => void): void };
  };
  launchQueue?.setConsumer(({ files: [handle] }) => {
    if (!handle) return;
    editor.attempt(async () => {
      const file = await handle.getFile();
      await editor.openFileBytes(new Uint8Array(await file.arrayBuffer()), { name: file.name, handle });
    });
  });
}
