export {imageCoordinates} from '../model/print-coordinates.js';
