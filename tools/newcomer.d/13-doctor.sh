# marketgen doctor
marketgen doctor
! marketgen doctor | grep "$TREE"
