/** Files, as users drag them onto a page, by their path with `/`: 'room/textures/wall.png'. */
export type FileMap = ReadonlyMap<string, File>;

/** All files of a drop event's DataTransfer, including the content of folders. */
export async function collectFiles(transfer: DataTransfer): Promise<FileMap> {
  const files = new Map<string, File>();
  // The items are cleared after the first await, so all are read before.
  const entries: FileSystemEntry[] = [];
  for (const item of transfer.items) {
    const entry = item.kind === 'file' ? item.webkitGetAsEntry?.() : null;
    if (entry) entries.push(entry);
  }
  const plain = [...transfer.files];
  if (entries.length === 0) for (const file of plain) files.set(file.name, file);
  for (const entry of entries) await addEntry(entry, files);
  return files;
}

async function addEntry(entry: FileSystemEntry, files: Map<string, File>): Promise<void> {
  if (entry.isFile) {
    const file = await new Promise<File>((resolve, reject) => (entry as FileSystemFileEntry).file(resolve, reject));
    files.set(entry.fullPath.replace(/^\//, ''), file);
    return;
  }
  const reader = (entry as FileSystemDirectoryEntry).createReader();
  for (;;) {
    // A reader returns at most 100 entries at a time, and none at the end.
    const batch = await new Promise<FileSystemEntry[]>((resolve, reject) => reader.readEntries(resolve, reject));
    if (batch.length === 0) return;
    for (const child of batch) await addEntry(child, files);
  }
}
