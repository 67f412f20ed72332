/** Path of the WebSocket, and folder of the assets' bytes. */
export const livePath = '/farol-live';
