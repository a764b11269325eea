import '../../../web/src/element/auto.js';
